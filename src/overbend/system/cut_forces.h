/// Force and moment in a line from the equilibrium on one side of a cut: more accurate than derivatives of the shape,
/// and exact at a roller, where the moment has a kink. Shared by statics and dynamics.
#pragma once

#include <cmath>
#include <vector>

#include "base/vec.h"

namespace overbend {

/// Internal force and moment at a cut.
struct CutForces {
  Vec3 force = Vec3::Zero();   ///< On the part towards the first node by the part towards the last, W [N].
  Vec3 moment = Vec3::Zero();  ///< [N m]
};

/// Returns the cut at a node, from LineAssembly::cuts() and the unknowns at which they were evaluated, six per node
/// each.
inline CutForces cut_at_node(const std::vector<double>& cuts, const std::vector<double>& q, std::size_t node) {
  using Map = Eigen::Map<const Vec3>;
  const Vec3 tangent = Map(q.data() + 6 * node + 3);
  return {Map(cuts.data() + 6 * node), tangent.cross(Vec3(Map(cuts.data() + 6 * node + 3)))};
}

/// Returns the upward unit vector perpendicular to a direction in its vertical plane; for a vertical direction
/// perpendicular to the world's y.
inline Vec3 up_across(const Vec3& tangent) {
  Vec3 up = Vec3::UnitZ() - tangent.z() * tangent;
  if (up.norm() < 1e-9) up = Vec3::UnitY().cross(tangent);
  return up.normalized();
}

/// Returns the horizontal component of a cut's total force, shear included; negative if the line is in compression [N].
inline double horizontal_tension(const Vec3& force, const Vec3& tangent) {
  return std::copysign(force.head<2>().norm(), force.dot(tangent));
}

}  // namespace overbend
