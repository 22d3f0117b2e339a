/// Quantities of dynamic results for readers: full names, customary units.
#pragma once

#include <string>
#include <string_view>

#include "base/shown_unit.h"

namespace overbend {

/// Display of a quantity: SI value times `factor`, with `digits` decimals.
struct Quantity {
  std::string name, unit;
  double factor = 1.0;
  int digits = 3;
  int more = 0;  ///< Decimals in addition to those requested, see base/shown_unit.h.

  /// Converts an SI value to the unit shown.
  double shown(double si) const { return factor * si; }
  std::string text(double si) const { return text(si, digits); }
  std::string text(double si, int decimals) const;
};

/// Returns the display of a history or an extreme by its script name and SI units: "support/stinger 8/reaction" in N
/// becomes "Reaction, stinger 8" in kN. An unknown name is shown with blanks for underscores; unknown units are kept.
Quantity quantity(const std::string& name, const std::string& units);

// Display of quantities without a name.
inline Quantity forces() {
  return quantity("force", "N");
}
inline Quantity moments() {
  return quantity("moment", "N m");
}
inline Quantity stresses() {
  return quantity("stress", "Pa");
}
inline Quantity strains() {
  return quantity("strain", "1");
}
inline Quantity angles() {
  return quantity("angle", "rad");
}
inline Quantity line_loads() {
  return quantity("line_load", "N/m");
}
inline Quantity dents() {
  return quantity("dent_depth", "m");
}
inline Quantity lengths() {
  return quantity("length", "m");
}
/// Small distances between pipe and roller, dimensions of a cross-section.
Quantity clearances();

// Units used only in reports.
ShownUnit line_weight();     ///< Ropes and chains [N/m].
ShownUnit impulse();         ///< [N s]
ShownUnit rope_stiffness();  ///< [N]
ShownUnit steel_area();      ///< [m2]
ShownUnit steel_inertia();   ///< [m4]

/// Returns the unit for values of a key or a result stored in `si`, spelled as in the model file ("N*m"): `metric`, the
/// unit of the file, or the US unit.
std::string unit_of_key(const std::string& si, const std::string& metric);

/// Returns "Lay-back [m]": a name with the display unit of its values.
std::string name_with_unit(const std::string& name, std::string_view si);

/// Formats a duration [s] in the largest unit with a value above one: "45 s", "10 min", "3 h".
std::string readable_duration(double seconds);

}  // namespace overbend
