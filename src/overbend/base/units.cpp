#include "base/units.h"

#include <udunits2.h>

#include <array>
#include <charconv>
#include <cstdio>
#include <map>
#include <memory>
#include <mutex>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "base/require.h"
#include "base/text.h"
#include "base/unit_spelling.h"

namespace overbend {
namespace {

struct UnitDeleter {
  void operator()(ut_unit* unit) const { ut_free(unit); }
};
using Unit = std::unique_ptr<ut_unit, UnitDeleter>;

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

/// The library's unit system with industry spellings; one per program, used under its mutex (UDUNITS keeps global
/// state).
class UnitSystem {
 public:
  static UnitSystem& instance() {
    static UnitSystem system;
    return system;
  }

  /// Returns the base units of a unit, "m-2.kg.s-2"; empty if it is unknown or not a pure scale (degC, lg(re 1 mW)).
  std::string signature(const std::string& unit) {
    const std::lock_guard lock(mutex_);
    return signature_text(parse(unit).get());
  }

  std::optional<double> factor(const std::string& unit, const std::string& si_unit) {
    const std::lock_guard lock(mutex_);
    const auto key = std::make_pair(unit, si_unit);
    if (const auto known = factors_.find(key); known != factors_.end()) return known->second;
    const std::optional<double> result = convert(parse(unit).get(), parse(si_unit).get());
    if (factors_.size() < kMaxCached) factors_.emplace(key, result);
    return result;
  }

 private:
  static constexpr std::size_t kMaxCached = 1000;

  UnitSystem() {
    ut_set_error_message_handler(ut_ignore);
    system_.reset(ut_read_xml(nullptr));
    if (!system_) throw std::runtime_error("the unit database of UDUNITS-2 cannot be read (package libudunits2-data)");
  }

  Unit parse(const std::string& unit) { return Unit(ut_parse(system_.get(), udunits_spelling(unit).c_str(), UT_UTF8)); }

  static std::string signature_text(const ut_unit* unit) {
    if (unit == nullptr) return {};
    std::array<char, 256> buffer{};
    const int length = ut_format(unit, buffer.data(), buffer.size() - 1, UT_DEFINITION | UT_ASCII);
    if (length <= 0 || length >= static_cast<int>(buffer.size()) - 1) return {};
    const std::string text(buffer.data(), static_cast<std::size_t>(length));
    if (text.find_first_of("@(") != std::string::npos) return {};
    const std::size_t space = text.find(' ');  // "1000 m-2.kg.s-2": a scale precedes the base units
    if (space != std::string::npos) return text.substr(space + 1);
    return parse_number(text) ? "1" : text;
  }

  static std::optional<double> convert(ut_unit* from, ut_unit* to) {
    const std::string signature = signature_text(from);
    if (signature.empty() || signature != signature_text(to)) return std::nullopt;
    const std::unique_ptr<cv_converter, void (*)(cv_converter*)> converter(ut_get_converter(from, to), cv_free);
    if (!converter) return std::nullopt;
    return cv_convert_double(converter.get(), 1.0);
  }

  struct SystemDeleter {
    void operator()(ut_system* system) const { ut_free_system(system); }
  };
  std::mutex mutex_;
  std::unique_ptr<ut_system, SystemDeleter> system_;
  std::map<std::pair<std::string, std::string>, std::optional<double>> factors_;
};

const DimensionNames* find_dimension(const std::string& si_unit) {
  for (const DimensionNames& d : dimensions()) {
    if (si_unit == d.si_unit) return &d;
  }
  return nullptr;
}

/// Returns the dimension of a known unit: "a force". Units beyond our table are "of another dimension".
std::string measured_dimension(const std::string& unit) {
  const std::string signature = UnitSystem::instance().signature(unit);
  for (const DimensionNames& d : dimensions()) {
    if (signature == UnitSystem::instance().signature(d.si_unit)) return d.phrase;
  }
  return "another dimension";
}

/// Length of the number at the start of the text.
std::size_t number_length(std::string_view text) {
  std::size_t i = 0;
  const auto digits = [&] {
    const std::size_t start = i;
    while (i < text.size() && text[i] >= '0' && text[i] <= '9') ++i;
    return i > start;
  };
  if (i < text.size() && (text[i] == '+' || text[i] == '-')) ++i;
  bool any = digits();
  if (i < text.size() && text[i] == '.') {
    ++i;
    any = digits() || any;
  }
  if (!any) return 0;
  const std::size_t mantissa_end = i;
  if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
    ++i;
    if (i < text.size() && (text[i] == '+' || text[i] == '-')) ++i;
    if (!digits()) i = mantissa_end;
  }
  return i;
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
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
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
  if (!looks_like_a_unit(unit_text) || UnitSystem::instance().signature(unit).empty()) {
    return {std::nullopt, quoted + " (unknown unit '" + unit + "')", other_unit_hint(unit_text, si_unit)};
  }
  const std::optional<double> factor = unit_factor(unit, si_unit);
  if (!factor) {
    return {std::nullopt, quoted + " (" + measured_dimension(unit) + ")", wrong_dimension_hint(*number, unit, si_unit)};
  }
  if (!std::isfinite(*number * *factor)) return {std::nullopt, quoted + ", which is out of range", {}};
  return {*number * *factor, quoted, {}, ambiguity_remark(unit)};
}

std::optional<double> unit_factor(const std::string& unit, const std::string& si_unit) {
  return UnitSystem::instance().factor(unit, si_unit);
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
