#include "statics/solver/planar_start.h"

#include <cmath>

namespace overbend {
namespace {

/// Rotates a vector about the vertical into the plane of `astern`, keeping its sense along it.
Vec3 turned_into(const Vec3& astern, const Vec3& v) {
  const double level = std::copysign(std::hypot(v.x(), v.y()), v.dot(astern));
  return level * astern + v.z() * Vec3::UnitZ();
}

}  // namespace

StaticSolution flattened_lay(const Model& model, const StaticSolution& solution) {
  StaticSolution flat = solution;
  const LayPlane plane = lay_plane(model, model.mean_pose);
  if (!plane.route.straight()) return flat;
  const auto place = [](const LineState& state, int node) { return Vec3(state.q.data() + 6 * node); };
  const int top = solution.mesh.nodes() - 1;
  for (int node = top; node >= 0; --node) {
    Eigen::Map<Vec3> r(flat.state.q.data() + 6 * node), t(flat.state.q.data() + 6 * node + 3);
    if (node < top) {
      const Vec3 chord = place(solution.state, node) - place(solution.state, node + 1);
      r = place(flat.state, node + 1) + turned_into(plane.astern_W, chord);
    }
    t = turned_into(plane.astern_W, Vec3(t));
  }
  flat.state.low.clear();  // digits beyond a double belong to the previous positions
  return flat;
}

}  // namespace overbend
