/// Units in which people read results: one table for tables of text, command line, reports and the page.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "base/constants.h"

namespace overbend {

/// How values of an SI unit are shown: times `factor`, usually with `digits` decimals.
struct ShownUnit {
  std::string_view si;
  std::string_view name;  ///< Empty for plain numbers.
  double factor = 1.0;
  int digits = 3;
};

inline constexpr std::array<ShownUnit, 12> kShownUnits = {{{"N", "kN", 1e-3, 1},
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
                                                           {"-", "", 1.0, 6}}};

/// Quantities that are read in a unit of their own: those whose name holds `part`.
struct OwnUnit {
  std::string_view part;
  ShownUnit unit;
};
inline constexpr std::array<OwnUnit, 3> kOwnUnits = {
    {{"strain", {"1", "%", 1e2, 4}}, {"contact_share", {"1", "%", 1e2, 1}}, {"dent_depth", {"m", "mm", 1e3, 3}}}};

/// Of the quantity `name`, which may be any text that holds what it is ("design strain"), kept in `si`. An SI unit that
/// is not in the table is shown as it is.
constexpr ShownUnit shown_unit(std::string_view name, std::string_view si) {
  for (const OwnUnit& own : kOwnUnits) {
    if (own.unit.si == si && name.find(own.part) != std::string_view::npos) return own.unit;
  }
  for (const ShownUnit& unit : kShownUnits) {
    if (unit.si == si) return unit;
  }
  return {si, si, 1.0, 3};
}

/// Its name, or a dash for plain numbers.
inline std::string text_of(const ShownUnit& unit) {
  return unit.name.empty() ? "-" : std::string(unit.name);
}

}  // namespace overbend
