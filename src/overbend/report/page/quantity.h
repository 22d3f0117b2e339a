/// Quantities of dynamic results as a reader wants them: names in words, customary units.
#pragma once

#include <string>
#include <string_view>

#include "base/shown_unit.h"

namespace overbend {

/// How a quantity is shown: SI value times `factor`, with `digits` decimals.
struct Quantity {
  std::string name, unit;
  double factor = 1.0;
  int digits = 3;
  int more = 0;  ///< Decimals more than asked for, see base/shown_unit.h.

  double shown(double si) const { return factor * si; }
  std::string text(double si) const { return text(si, digits); }
  std::string text(double si, int decimals) const;
};

/// For the script name and SI units of a history or an extreme: "support/stinger 8/reaction" in N becomes
/// "Reaction, stinger 8" in kN. An unknown name is shown as it is, with underscores as blanks; unknown units
/// stay.
Quantity quantity(const std::string& name, const std::string& units);

// What has no name of its own.
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
/// Small distances between pipe and roller, lengths of a cross-section.
Quantity clearances();

// Units of reports alone.
ShownUnit line_weight();     ///< Of ropes and chains [N/m].
ShownUnit impulse();         ///< [N s]
ShownUnit rope_stiffness();  ///< [N]
ShownUnit steel_area();      ///< [m2]
ShownUnit steel_inertia();   ///< [m4]

/// The unit for values of a key or a result kept in `si`, spelled as in the model file ("N*m"): `metric`, which is the
/// one it is written in, or the US unit.
std::string unit_of_key(const std::string& si, const std::string& metric);

/// "Lay-back [m]": a name with the unit that its values are shown in.
std::string name_with_unit(const std::string& name, std::string_view si);

/// A duration in the largest unit that leaves it above one: "45 s", "10 min", "3 h". [s]
std::string duration_words(double seconds);

}  // namespace overbend
