#include "base/shown_unit.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

#include "base/constants.h"

namespace overbend {
namespace {

constexpr double kFoot = 0.3048, kInch = 0.0254, kPound = 0.45359237;
constexpr double kPoundForce = kPound * 9.80665, kKip = 1e3 * kPoundForce;
constexpr double kKsi = kKip / (kInch * kInch);

constexpr std::size_t kUnits = 22, kOwn = 3;
constexpr std::array<ShownUnit, kUnits> kMetric = {{{"N", "kN", 1e-3, 1},
                                                    {"N m", "kN m", 1e-3, 1},
                                                    {"N/m", "kN/m", 1e-3, 1},
                                                    {"N s", "kN s", 1e-3, 3},
                                                    {"Pa", "MPa", 1e-6, 1},
                                                    {"J", "kJ", 1e-3, 3},
                                                    {"rad", "deg", kToDegrees, 2},
                                                    {"rad/s", "deg/s", kToDegrees, 3},
                                                    {"m", "m", 1.0, 3},
                                                    {"s", "s", 1.0, 4},
                                                    {"1", "", 1.0, 6},
                                                    {"-", "", 1.0, 6},
                                                    {"m/s", "m/s", 1.0, 3},
                                                    {"m/s2", "m/s2", 1.0, 3},
                                                    {"m3", "m3", 1.0, 3},
                                                    {"1/m", "1/m", 1.0, 3},
                                                    {"N m2", "kN m2", 1e-3, 1},
                                                    {"N m/rad", "kN m/rad", 1e-3, 1},
                                                    {"N/m2", "kN/m2", 1e-3, 1},
                                                    {"N/m3", "kN/m3", 1e-3, 2},
                                                    {"kg", "t", 1e-3, 1},
                                                    {"kg/m", "kg/m", 1.0, 2}}};
constexpr std::array<ShownUnit, kUnits> kUs = {{{"N", "kip", 1.0 / kKip, 2, 1},
                                                {"N m", "kip ft", 1.0 / (kKip * kFoot), 2, 1},
                                                {"N/m", "lbf/ft", kFoot / kPoundForce, 0, -1},
                                                {"N s", "kip s", 1.0 / kKip, 4, 1},
                                                {"Pa", "ksi", 1.0 / kKsi, 2, 1},
                                                {"J", "kip ft", 1.0 / (kKip * kFoot), 4, 1},
                                                {"rad", "deg", kToDegrees, 2},
                                                {"rad/s", "deg/s", kToDegrees, 3},
                                                {"m", "ft", 1.0 / kFoot, 3},
                                                {"s", "s", 1.0, 4},
                                                {"1", "", 1.0, 6},
                                                {"-", "", 1.0, 6},
                                                {"m/s", "ft/s", 1.0 / kFoot, 3},
                                                {"m/s2", "ft/s2", 1.0 / kFoot, 3},
                                                {"m3", "ft3", 1.0 / (kFoot * kFoot * kFoot), 2, -1},
                                                {"1/m", "1/ft", kFoot, 4, 1},
                                                {"N m2", "kip ft2", 1.0 / (kKip * kFoot * kFoot), 1},
                                                {"N m/rad", "kip ft/rad", 1.0 / (kKip * kFoot), 2, 1},
                                                {"N/m2", "lbf/ft2", kFoot* kFoot / kPoundForce, 0, -1},
                                                {"N/m3", "lbf/ft3", kFoot* kFoot* kFoot / kPoundForce, 2},
                                                {"kg", "lb", 1.0 / kPound, 0, -3},
                                                {"kg/m", "lb/ft", kFoot / kPound, 3, 1}}};
constexpr std::array<SpecialUnit, kOwn> kOwnMetric = {
    {{"strain", {"1", "%", 1e2, 4}}, {"contact_share", {"1", "%", 1e2, 1}}, {"dent_depth", {"m", "mm", 1e3, 3}}}};
constexpr std::array<SpecialUnit, kOwn> kOwnUs = {{{"strain", {"1", "%", 1e2, 4}},
                                                   {"contact_share", {"1", "%", 1e2, 1}},
                                                   {"dent_depth", {"m", "in", 1.0 / kInch, 5, 2}}}};

std::atomic<UnitSystem>& in_use() {
  static std::atomic<UnitSystem> system = UnitSystem::metric;
  return system;
}

std::string with_unit(std::string number, const ShownUnit& unit) {
  return unit.name.empty() ? number : number.append(" ").append(unit.name);
}

}  // namespace

void use_units(UnitSystem system) {
  in_use() = system;
}

UnitSystem units_in_use() {
  return in_use();
}

std::span<const ShownUnit> shown_units(UnitSystem system) {
  return system == UnitSystem::us ? kUs : kMetric;
}

std::span<const SpecialUnit> special_units(UnitSystem system) {
  return system == UnitSystem::us ? kOwnUs : kOwnMetric;
}

ShownUnit shown_unit(std::string_view name, std::string_view si, UnitSystem system) {
  for (const SpecialUnit& entry : special_units(system)) {
    if (entry.unit.si == si && name.find(entry.part) != std::string_view::npos) return entry.unit;
  }
  for (const ShownUnit& unit : shown_units(system)) {
    if (unit.si == si) return unit;
  }
  return {si, si, 1.0, 3};
}

ShownUnit section_length() {
  return units_in_use() == UnitSystem::us ? ShownUnit{"m", "in", 1.0 / kInch, 3, 2} : ShownUnit{"m", "mm", 1e3, 1};
}

ShownUnit line_weight_unit() {
  return units_in_use() == UnitSystem::us ? shown_unit("N/m") : ShownUnit{"N/m", "N/m", 1.0, 1};
}

ShownUnit contact_stiffness_unit() {
  return units_in_use() == UnitSystem::us ? ShownUnit{"N/m", "kip/in", kInch / kKip, 1}
                                          : ShownUnit{"N/m", "MN/m", 1e-6, 1};
}

ShownUnit axial_stiffness_unit() {
  return units_in_use() == UnitSystem::us ? ShownUnit{"N", "kip", 1.0 / kKip, 0, -1} : ShownUnit{"N", "MN", 1e-6, 1};
}

ShownUnit modulus_unit() {
  return units_in_use() == UnitSystem::us ? ShownUnit{"Pa", "ksi", 1.0 / kKsi, 0, -1} : ShownUnit{"Pa", "GPa", 1e-9, 1};
}

ShownUnit bed_stiffness_unit() {
  ShownUnit unit = shown_unit("N/m2");
  unit.name = shown_unit("N/m").name;
  return unit;
}

ShownUnit route_length() {
  return units_in_use() == UnitSystem::us ? ShownUnit{"m", "ft", 1.0 / kFoot, 0, -3} : ShownUnit{"m", "km", 1e-3, 3};
}

std::string fixed(double value, int digits) {
  if (!std::isfinite(value)) return "-";
  std::string text = fmt::format("{:.{}f}", value, digits);
  const bool zero = text.find_first_not_of("-0.") == std::string::npos;
  return zero && text.front() == '-' ? text.substr(1) : text;
}

std::string unit_label(const ShownUnit& unit) {
  return unit.name.empty() ? "-" : std::string(unit.name);
}

std::string shown_number(double value, const ShownUnit& unit, int decimals) {
  return fixed(value * unit.factor, std::max(0, decimals + unit.more));
}

std::string shown(double value, const ShownUnit& unit, int decimals) {
  return with_unit(shown_number(value, unit, decimals), unit);
}

std::string shown_digits_number(double value, const ShownUnit& unit, int digits) {
  const double shown_value = value * unit.factor;
  std::string text = fmt::format("{:.{}g}", shown_value, digits);
  // US units are often so small that a metric number of three digits has four: no exponent for those.
  const bool large = units_in_use() == UnitSystem::us && text.find("e+") != std::string::npos;
  return large ? fixed(shown_value, 0) : text;
}

std::string shown_digits(double value, const ShownUnit& unit, int digits) {
  return with_unit(shown_digits_number(value, unit, digits), unit);
}

}  // namespace overbend
