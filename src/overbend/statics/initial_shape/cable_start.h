/// A first shape of a cable between two places: an elastic catenary of the cable's mean weight and stiffness, on the
/// bed where its lower end stands there. Newton's method makes the line of it, segments, points and current included.
#pragma once

#include <optional>
#include <vector>

#include "system/cable_line.h"

namespace overbend {

/// A catenary in its vertical plane, seen from its lower end; of a buoyant cable turned upside down.
struct CableStart {
  double length = 0.0, weight = 0.0, EA = 0.0;       ///< [m], submerged [N/m] and above zero, [N]
  double horizontal = 0.0, vertical = 0.0;           ///< Force at the upper end [N].
  double on_bed = 0.0;                               ///< Length that lies [m].
  bool buoyant = false;                              ///< Hangs upwards.
  bool from_second = false;                          ///< The lower end is the second.
  Vec3 lower = Vec3::Zero(), ahead = Vec3::UnitX();  ///< Of the lower end, and horizontal unit vector from there.
  bool slack = false;                     ///< Longer than the way along the bed and up: the rest lies in a bow.
  bool straight = false;                  ///< Too taut for a catenary to be found.
  double lowest = -1e30, highest = 1e30;  ///< Between bed and, where it floats, surface [m].
  double across = 0.0, up = 0.0;          ///< Of the upper end from the lower [m].

  /// Arc length from the first end at which the cable leaves the bed; none where nothing lies.
  std::optional<double> touchdown() const;
  /// Six unknowns for every node.
  std::vector<double> shape(const LineMesh& mesh) const;
};

/// Solved by Newton's method from the start of Jonkman (2007); where that does not converge, a straight line between
/// the places, or where there is more than enough of it one straight down to the bed and there in a bow.
CableStart cable_start(const Model& model, const CableParts& parts, const Vec3& first, const Vec3& second);

}  // namespace overbend
