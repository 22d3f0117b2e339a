#include "base/units.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <mutex>
#include <numbers>
#include <utility>

#include "base/read_double.h"
#include "base/require.h"
#include "base/text.h"
#include "base/unit_parser.h"
#include "base/unit_spelling.h"

namespace overbend {
namespace {

struct DimensionNames {
  const char* si_unit;
  const char* phrase;
  std::vector<std::string> units;
};

const std::vector<DimensionNames>& dimensions() {
  static const std::vector<DimensionNames> kDimensions = {
      {"m", "a length", {"m", "mm", "cm", "km", "in", "ft"}},
      {"rad", "an angle", {"deg", "rad"}},
      {"s", "a time", {"s", "min", "h", "ms"}},
      {"m/s", "a speed", {"m/s", "knot", "ft/s", "km/h", "m/min"}},
      {"m/s^2", "an acceleration", {"m/s^2", "ft/s^2"}},
      {"N", "a force", {"kN", "N", "MN", "kip", "lbf", "tf"}},
      {"N/m", "a force per length", {"kN/m", "N/m", "MN/m", "lbf/ft", "kip/in"}},
      {"N/m^2", "a force per area", {"MPa", "GPa", "kN/m^2", "Pa", "N/mm^2", "bar", "psi", "ksi"}},
      {"N/m^3", "a weight density", {"kN/m^3", "N/m^3", "lbf/ft^3"}},
      {"N*s/m^2", "a damping per length", {"kN*s/m^2", "N*s/m^2"}},
      {"N*m", "a moment", {"kN*m", "N*m", "kip*ft"}},
      {"N*m^2", "a bending stiffness", {"kN*m^2", "N*m^2"}},
      {"kg", "a mass", {"kg", "t", "lb"}},
      {"kg/m", "a mass per length", {"kg/m", "t/m", "lb/ft"}},
      {"kg/m^3", "a mass density", {"kg/m^3"}},
      {"m-1", "a curvature", {"1/m", "1/ft"}},
      {"m^2", "an area", {"m^2", "mm^2"}},
      {"1/s", "a frequency", {"Hz"}},
      {"rad/s", "an angular speed", {"rad/s"}},
      {"1", "a plain number", {}},
  };
  return kDimensions;
}

/// Reads a unit with industry spellings; empty if it is unknown or not a pure scale (degC, lg(re 1 mW)).
std::optional<ParsedUnit> parse_scale(std::string_view text) {
  const std::optional<ParsedUnit> unit = parse_unit(udunits_spelling(text));
  return unit && unit->is_scale() ? unit : std::nullopt;
}

std::optional<double> compute_factor(std::string_view unit, std::string_view si_unit) {
  const std::optional<ParsedUnit> from = parse_scale(unit), to = parse_scale(si_unit);
  if (!from || !to || from->powers != to->powers) return std::nullopt;
  return from->scale * (1.0 / to->scale);
}

const DimensionNames* find_dimension(const std::string& si_unit) {
  for (const DimensionNames& d : dimensions()) {
    if (si_unit == d.si_unit) return &d;
  }
  return nullptr;
}

/// Returns the dimension of a known unit: "a force". Units beyond our table are "of another dimension".
std::string measured_dimension(const std::string& unit) {
  for (const DimensionNames& d : dimensions()) {
    if (compute_factor(unit, d.si_unit)) return d.phrase;
  }
  return "another dimension";
}

/// True for names, powers, products and quotients, such as "1/m". UDUNITS also reads scales, shifts and logarithms,
/// which are not accepted here.
bool looks_like_a_unit(std::string_view unit) {
  if (unit.size() > 40) return false;
  if (unit.substr(0, 2) == "1/") unit.remove_prefix(2);
  if (unit.empty()) return false;
  const char first = unit.front();
  if ((first >= '0' && first <= '9') || std::string_view("+-*/.^,()").find(first) != std::string_view::npos) {
    return false;
  }
  return unit.find_first_of("@,:;=&|<>{}[]\\\t\n\r") == std::string_view::npos;
}

std::string expected_units(const std::string& si_unit) {
  const std::vector<std::string> units = usual_units(si_unit);
  return units.empty() ? std::string() : "write a unit such as " + join_items({units.begin(), units.end()}, "or");
}

/// Returns a hint for a unit that is unknown or of another dimension.
std::string other_unit_hint(std::string_view unit, const std::string& si_unit) {
  for (const std::string& known : usual_units(si_unit)) {
    if (lower_case(known) == lower_case(unit)) return "did you mean '" + known + "'? (capitals matter in units)";
  }
  const std::string spelling = spelling_hint(unit);
  return spelling.empty() ? expected_units(si_unit) : spelling;
}

/// Returns a hint on common mix-ups, mass for weight and turns for radians per second, with the corrected number.
std::string wrong_dimension_hint(double number, const std::string& unit, const std::string& si_unit) {
  if (usual_units(si_unit).empty()) return other_unit_hint(unit, si_unit);
  constexpr double kStandardGravity = 9.80665;
  const auto would_be = [&](double si) { return format_quantity(si, si_unit, usual_units(si_unit).front(), 5); };
  if (const auto mass = unit_factor(unit + " m/s^2", si_unit)) {
    return "that is a mass; its weight is " + would_be(number * *mass * kStandardGravity);
  }
  if (const auto turns = unit_factor(unit + " rad", si_unit)) {
    return "that is a frequency; the angular frequency is " + would_be(number * *turns * 2.0 * std::numbers::pi);
  }
  if (const auto angular = unit_factor(unit + " rad-1", si_unit)) {
    return "that is an angular frequency; the frequency is " + would_be(number * *angular / (2.0 * std::numbers::pi));
  }
  return other_unit_hint(unit, si_unit);
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  if (text.empty() || number_length(text) != text.size()) return std::nullopt;
  if (text.front() == '+') text.remove_prefix(1);
  const std::string_view unsigned_text = text.front() == '-' ? text.substr(1) : text;
  if (unsigned_text.size() > 1 && unsigned_text[0] == '0' && unsigned_text[1] >= '0' && unsigned_text[1] <= '9') {
    return std::nullopt;
  }
  double value = 0.0;
  const auto [end, error] = read_double(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

QuantityReading parse_quantity(std::string_view text, const std::string& si_unit) {
  const std::string quoted = "'" + std::string(text) + "'";
  const std::size_t length = number_length(text);
  if (length == 0) return {std::nullopt, quoted, expected_units(si_unit)};
  const std::optional<double> number = parse_number(text.substr(0, length));
  if (!number) {
    return {std::nullopt, quoted + ", not a decimal number", "write it without leading zeros and below 1e308"};
  }
  const std::string_view unit_text = trim(text.substr(length));
  if (unit_text.empty()) return {std::nullopt, quoted + " without a unit", expected_units(si_unit)};
  if (unit_text.front() == ',') return {std::nullopt, quoted, "the decimal sign is a point"};
  const std::string unit(unit_text);
  const bool acceptable = looks_like_a_unit(unit_text);
  const std::optional<double> factor = acceptable ? unit_factor(unit, si_unit) : std::nullopt;
  if (!factor && (!acceptable || !parse_scale(unit))) {
    return {std::nullopt, quoted + " (unknown unit '" + unit + "')", other_unit_hint(unit_text, si_unit)};
  }
  if (!factor) {
    return {std::nullopt, quoted + " (" + measured_dimension(unit) + ")", wrong_dimension_hint(*number, unit, si_unit)};
  }
  if (!std::isfinite(*number * *factor)) return {std::nullopt, quoted + ", which is out of range", {}};
  return {*number * *factor, quoted, {}, ambiguity_remark(unit)};
}

std::optional<double> unit_factor(const std::string& unit, const std::string& si_unit) {
  constexpr std::size_t kMaxCached = 1000;
  static std::mutex mutex;
  static std::map<std::pair<std::string, std::string>, std::optional<double>> factors;
  const std::lock_guard lock(mutex);
  const auto key = std::make_pair(unit, si_unit);
  if (const auto known = factors.find(key); known != factors.end()) return known->second;
  const std::optional<double> result = compute_factor(unit, si_unit);
  if (factors.size() < kMaxCached) factors.emplace(key, result);
  return result;
}

std::string dimension_phrase(const std::string& si_unit) {
  const DimensionNames* names = find_dimension(si_unit);
  return names != nullptr ? names->phrase : "a quantity in " + si_unit;
}

std::string dimension_name(const std::string& si_unit) {
  const std::string dimension = dimension_phrase(si_unit);
  return dimension.substr(dimension.find(' ') + 1);
}

std::vector<std::string> usual_units(const std::string& si_unit) {
  const DimensionNames* names = find_dimension(si_unit);
  return names != nullptr ? names->units : std::vector<std::string>{si_unit};
}

std::string format_quantity(double value, const std::string& si_unit, const std::string& unit, int digits) {
  const std::optional<double> factor = unit_factor(unit, si_unit);
  if (!factor) broken_promise("a unit measures its dimension: '" + unit + "', " + dimension_phrase(si_unit));
  return format_number(value / *factor, digits) + " " + unit;
}

std::string format_number(double value, int digits) {
  std::array<char, 64> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.*g", digits, value);
  return buffer.data();
}

}  // namespace overbend
