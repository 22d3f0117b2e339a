/// Initial shape of a cable between two places: an elastic catenary with the cable's mean weight and stiffness, on the
/// bed if its lower end is there. Newton's method then includes segments, points and current.
#pragma once

#include <optional>
#include <vector>

#include "system/cable_line.h"

namespace overbend {

/// Catenary in its vertical plane, seen from its lower end; that of a buoyant cable is turned upside down.
struct CableShape {
  double length = 0.0, weight = 0.0, EA = 0.0;       ///< [m], submerged [N/m] (positive), [N]
  double horizontal = 0.0, vertical = 0.0;           ///< Force at the upper end [N].
  double on_bed = 0.0;                               ///< Length on the bed [m].
  bool buoyant = false;                              ///< Suspended upwards.
  bool from_second = false;                          ///< The lower end is the second end.
  Vec3 lower = Vec3::Zero(), ahead = Vec3::UnitX();  ///< Position of the lower end, and horizontal unit vector from it
                                                     ///< to the upper end.
  bool slack = false;                     ///< Longer than the path along the bed and up: the excess lies in an arc.
  bool straight = false;                  ///< Too taut for a catenary to be found.
  double lowest = -1e30, highest = 1e30;  ///< Bounds of the height: bed and, for a buoyant cable, water surface [m].
  double across = 0.0, up = 0.0;          ///< Distance of the upper end from the lower: horizontal, vertical [m].

  /// Arc length from the first end at which the cable leaves the bed; nullopt if no part lies on the bed.
  std::optional<double> touchdown() const;
  /// Shape with six unknowns per node.
  std::vector<double> shape(const LineMesh& mesh) const;
};

/// Solved by Newton's method from the initial values of Jonkman (2007). If that does not converge: a straight line
/// between the places or, if the cable is long enough, a vertical line down to the bed and an arc on it.
CableShape make_cable_shape(const Model& model, const CableParts& parts, const Vec3& first, const Vec3& second);

}  // namespace overbend
