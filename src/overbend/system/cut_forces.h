/// Force and moment in a line by the balance of what lies on one side of a cut: more accurate than derivatives of the
/// shape, and exact at a roller, where the moment has a kink. One recovery for statics and dynamics.
#pragma once

#include <vector>

#include "base/vec.h"

namespace overbend {

struct CutForces {
  Vec3 force = Vec3::Zero();   ///< On the part towards the first node, by the part towards the last, W [N].
  Vec3 moment = Vec3::Zero();  ///< [N m]
};

/// At a node, from LineAssembly::cuts() and the unknowns they were evaluated at, six per node each.
inline CutForces cut_at_node(const std::vector<double>& cuts, const std::vector<double>& q, std::size_t node) {
  using Map = Eigen::Map<const Vec3>;
  const Vec3 tangent = Map(q.data() + 6 * node + 3);
  return {Map(cuts.data() + 6 * node), tangent.cross(Vec3(Map(cuts.data() + 6 * node + 3)))};
}

}  // namespace overbend
