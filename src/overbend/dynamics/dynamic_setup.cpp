#include "dynamics/dynamic_setup.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mechanics/ground.h"
#include "mechanics/quadrature.h"
#include "system/vessel_body.h"

namespace overbend {
namespace {

/// Stretch of the bed's friction at a point that statics holds with these forces: across the route, along it.
struct StaticStretch {
  double across, along;
};

StaticStretch static_stretch(const LineEnvironment& env, const Vec3& r, double radius, double submerged_weight) {
  const GroundPoint ground = ground_at(env, r);
  const double force = env.bed_stiffness * std::max(0.0, radius - ground.clearance);
  if (force <= 0.0 || env.bed_stick <= 0.0) {
    return {0.0, 0.0};
  }
  const double limit_across = env.bed_friction_lateral * force / env.bed_stick;
  const double limit_along = env.bed_friction_axial * force / env.bed_stick;
  const double pull = submerged_weight * ground.along_route.z() / env.bed_stick;
  return {std::clamp(ground.off_route, -limit_across, limit_across), -std::clamp(pull, -limit_along, limit_along)};
}

/// The far end stays where statics put it.
Attachment anchor_of(const StaticSolution& start) {
  const std::vector<double>& q = start.state.q;
  Attachment anchor;
  anchor.end = LineEnd::first;
  anchor.hold_place = anchor.hold_direction = true;
  anchor.place = Vec3(q[0], q[1], q[2]);
  anchor.direction = Vec3(q[3], q[4], q[5]).normalized();
  return anchor;
}

/// Behind a guide that lets the pipe turn the machine stands in line with the pipe at rest.
Attachment tensioner_of(const Model& model, const StaticSolution& start, double static_tension) {
  const TensionerDescription& t = model.description.tensioner;
  const VesselDescription& v = model.description.vessel;
  Attachment top;
  top.end = LineEnd::last;
  top.hold_place = true;
  top.hold_direction = t.guide == Guide::clamped;
  top.body = 0;
  // The ramp's X runs astern, its Z up; the pipe's tangent points from the anchor to the tensioner.
  top.place = Vec3(v.stern_shoe_x - t.x, 0.0, v.stern_shoe_z + t.z);
  top.direction = Vec3(std::cos(t.incline), 0.0, std::sin(t.incline));
  if (t.guide == Guide::pinned) {
    const Vec3 tangent(Eigen::Map<const Vec3>(start.state.q.data() + start.state.q.size() - 3));
    top.direction = model.mean_pose.R_WV.transpose() * tangent.normalized();
  }
  top.tensioner = tensioner_law(t, static_tension);
  return top;
}

}  // namespace

TensionerLaw tensioner_law(const TensionerDescription& tensioner, double static_tension) {
  constexpr double kToSpeed = 0.5;      // [s]
  constexpr double kResolution = 1e-5;  // of the tension wanted; ten times what a step may leave out of balance
  TensionerLaw law;
  const bool can_move = tensioner.velocity > 0.0 || tensioner.mode == TensionerMode::constant;
  law.mode = can_move ? tensioner.mode : TensionerMode::locked;
  law.wanted = tensioner.tension.value_or(static_tension);
  law.low = tensioner.range_low.value_or(0.0);
  law.high = tensioner.range_high.value_or(0.0);
  law.delay = tensioner.delay;
  law.velocity = tensioner.velocity;
  law.acceleration = tensioner.acceleration.value_or(tensioner.velocity / kToSpeed);
  law.limit = tensioner.travel.value_or(std::numeric_limits<double>::infinity());
  law.resolution = kResolution * law.wanted;
  return law;
}

System pipe_system(const Model& model, const StaticSolution& solution, double static_tension) {
  System system;
  Line line = pipe_line(model, solution.mesh, lay_route(model, model.mean_pose));
  choose_levels(line.yielding, solution.state.q.data());
  // Without the laid tail carried on behind the static line: how well forces are balanced does not depend on its
  // length.
  line.force_scale = weight_from(line.mesh, line.elements, 0.0);
  const double radius =
      *std::max_element(line.elements.radius.begin(), line.elements.radius.begin() + line.elements.count);
  const double shortest = *std::min_element(line.mesh.length.begin(), line.mesh.length.end());
  system.bodies.push_back(vessel_body(model, shortest, radius));
  system.lines.push_back(std::move(line));
  system.attachments = {anchor_of(solution), tensioner_of(model, solution, static_tension)};
  system.machine = 1;
  return system;
}

SystemState static_state(const System& system, const StaticSolution& solution, double time) {
  SystemState state = state_at_rest(system, {solution.state.q}, time);
  const Line& line = system.lines.front();
  LineState& pipe = state.lines.front();
  if (!solution.bending.empty()) {
    pipe.bending = solution.bending;
  }
  const std::size_t padded = line.elements.padded();
  for (int e = 0; e < line.elements.count; ++e) {
    const std::size_t i = static_cast<std::size_t>(e);
    const ElementVector q(Eigen::Map<const ElementVector>(pipe.q.data() + 6 * e));
    for (int point = 0; point < kGaussPoints; ++point) {
      const Vec3 r = centreline(q, kGaussXi[point], line.mesh.length[i]).r;
      const StaticStretch stretch = static_stretch(line.environment, r, line.elements.radius[i],
                                                   line.elements.weight[i] - line.elements.buoyancy[i]);
      const std::size_t at = static_cast<std::size_t>(point * kBedDirections) * padded + i;
      pipe.bed_slip[at] = stretch.across;
      pipe.bed_slip[at + padded] = stretch.along;
    }
  }
  return state;
}

}  // namespace overbend
