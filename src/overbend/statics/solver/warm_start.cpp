#include "statics/solver/warm_start.h"

#include <algorithm>
#include <cmath>

#include "mechanics/rod_element.h"
#include "model/lay_stage.h"
#include "statics/equations/touchdown.h"
#include "statics/initial_shape/stage_shape.h"

namespace overbend {
namespace {

/// Unit vector on the bed in the vertical plane of the route, away from the vessel.
Vec3 along_bed(const LayPlane& plane, const Vec3& p_W) {
  const double distance = plane.route.distance(p_W);
  return (plane.route.direction(distance) + plane.bed_slope(distance) * Vec3::UnitZ()).normalized();
}

}  // namespace

void pin_far_end(const StaticSystem& system, LineState& state) {
  if (cable_at_far_end(system.model().description)) state.q[2] = pinned_height(system.model());
  const LayRoute& route = system.plane().route;
  Eigen::Map<Vec3> far(state.q.data()), tangent(state.q.data() + 3);
  if (!route.straight() && !system.lays_steadily()) far -= route.offset(far) * route.port(route.distance(far));
  if (const auto along = system.held_far_direction(route.distance(far))) tangent = -tangent.norm() * *along;
}

LineState interpolate(const LineMesh& from, const LineState& state, const LineMesh& to, const LayPlane& plane) {
  LineState moved;
  moved.far_force = state.far_force;
  moved.q.resize(6 * to.s.size());
  const double shift =
      from.total_length() - to.total_length();  // arc length counts from the anchor, nodes match from the top
  for (std::size_t node = 0; node < to.s.size(); ++node) {
    const double s = to.s[node] + shift;
    const auto after = std::upper_bound(from.s.begin(), from.s.end(), s);
    const std::size_t e =
        static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(after - from.s.begin() - 1, 0, from.elements() - 1));
    const ElementVector q(Eigen::Map<const ElementVector>(state.q.data() + 6 * e));
    const double xi = std::clamp((s - from.s[e]) / from.length[e], 0.0, 1.0);
    const CentrelinePoint point = centreline(q, xi, from.length[e]);
    const Vec3 beyond = s < 0.0 ? Vec3(-s * along_bed(plane, point.r)) : Vec3::Zero();
    Eigen::Map<Vec3> r(moved.q.data() + 6 * node);
    r = point.r + beyond;
    if (s < 0.0 && plane.surface.shape() != nullptr) r.z() = plane.bed(plane.route.distance(r));
    Eigen::Map<Vec3>(moved.q.data() + 6 * node + 3) = point.a;
  }
  return moved;
}

namespace {

Eigen::Isometry3d relative_motion(const VesselPose& before, const VesselPose& after) {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  if (after.R_WV == before.R_WV && after.p_WV == before.p_WV) return motion;  // exactly equal
  motion.linear() = after.R_WV * before.R_WV.transpose();
  motion.translation() = after.p_WV - motion.linear() * before.p_WV;
  return motion;
}

/// Rotation in plan from one direction to another.
Mat3 turn_in_plan(const Vec3& from, const Vec3& to) {
  const double angle = std::atan2(from.x() * to.y() - from.y() * to.x(), from.head<2>().dot(to.head<2>()));
  return Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix();
}

/// Motion of a laid line to the present route: its far end is put on the route, its top moves along it up to `top_now`.
/// The line turns into the direction in which the route holds its far end or, if it holds none or is curved, about its
/// top by the lateral displacement of the far end.
Eigen::Isometry3d laid_line_motion(const StaticSystem& system, const LineState& state, const Vec3& top_now) {
  const LayPlane& plane = system.plane();
  const Vec3 far(state.q.data()), tangent(state.q.data() + 3), top(state.q.data() + state.q.size() - 6);
  const double distance = plane.route.distance(far);
  Vec3 to = far;
  // otherwise it lies at an offset
  if (!system.lays_steadily()) to -= plane.route.offset(far) * plane.route.port(distance);
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  if (plane.route.straight() && system.held_far_direction(distance)) {
    motion.linear() = turn_in_plan(-tangent, plane.route.direction(distance));
  } else {
    motion.linear() = turn_in_plan(top_now - far, top_now - to);
  }
  to += plane.astern_W.dot(top_now - to - motion.linear() * (top - far)) * plane.astern_W;
  motion.translation() = to - motion.linear() * far;
  return motion;
}

}  // namespace

void move_to_ends(const StaticSystem& system, const VesselPose& before, double last_support, LineState& state) {
  const LayPlane& plane = system.plane();
  const LineMesh& mesh = system.mesh();
  const auto touchdown = find_touchdown(system, state);
  const double total = mesh.total_length(), landing = touchdown ? touchdown->s : 0.0;
  const double suspended = std::max(total - last_support - landing, 1.0);
  const Vec3 top(state.q.data() + state.q.size() - 6);
  const Eigen::Isometry3d carried = relative_motion(before, system.pose());
  const Eigen::Isometry3d laid = laid_line_motion(system, state, carried * top);
  const Vec3 miss = plane.tensioner_W - carried * top;
  const double along = miss.dot(plane.astern_W), across = miss.dot(plane.port_W);
  const Vec3 turn = across / total * plane.port_W, lift = miss.z() / (total - landing) * Vec3::UnitZ();
  for (std::size_t node = 0; node < mesh.s.size(); ++node) {
    Eigen::Map<Vec3> r(state.q.data() + 6 * node), t(state.q.data() + 6 * node + 3);
    const double s = mesh.s[node], above = std::max(0.0, s - landing);
    const double share = std::min(above / suspended, 1.0);
    const Vec3 with_vessel = carried * r, with_route = laid * r;
    t = share * (carried.linear() * t) + (1.0 - share) * (laid.linear() * t) + turn;
    if (share > 0.0) t += lift;
    if (share > 0.0 && share < 1.0) t += (with_vessel - with_route) / suspended;
    r = share * with_vessel + (1.0 - share) * with_route + along * plane.astern_W + s * turn + above * lift;
  }
  Eigen::Map<Vec3>(state.q.data() + state.q.size() - 6) = plane.tensioner_W;
  if (const auto& guide = system.held_direction()) {
    Eigen::Map<Vec3> tangent(state.q.data() + state.q.size() - 3);
    tangent = tangent.norm() * *guide;
  }
  pin_far_end(system, state);
}

}  // namespace overbend
