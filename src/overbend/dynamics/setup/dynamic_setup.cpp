#include "dynamics/setup/dynamic_setup.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dynamics/setup/initial_seabed_friction.h"
#include "model/lay_stage.h"
#include "statics/solver/steady_laying.h"
#include "system/vessel_body.h"

namespace overbend {
namespace {

/// The anchor end stays at its static position; a cable rotates freely there.
Attachment make_anchor_end(const Model& model, const StaticSolution& start) {
  const std::vector<double>& q = start.state.q;
  Attachment anchor;
  anchor.end = LineEnd::first;
  anchor.hold_place = true;
  anchor.hold_direction = !cable_at_far_end(model.description);
  anchor.place = Vec3(q[0], q[1], q[2]);
  anchor.direction = Vec3(q[3], q[4], q[5]).normalized();
  return anchor;
}

/// The machine is aligned with the pipe at rest if the guide lets the pipe rotate.
Attachment make_tensioner_end(const Model& model, const StaticSolution& start, double static_tension) {
  const TensionerDescription& t = model.description.tensioner;
  const VesselDescription& v = model.description.vessel;
  Attachment top;
  top.end = LineEnd::last;
  top.hold_place = true;
  top.hold_direction = t.guide == Guide::clamped;
  top.body = 0;
  // The ramp's X points astern, its Z up; the pipe's tangent points from the anchor to the tensioner.
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
  constexpr double kDefaultAccelerationTime = 0.5;  // [s]
  constexpr double kResolution = 1e-5;              // relative to the target tension; ten times the residual of a step
  TensionerLaw law;
  const bool can_move = tensioner.velocity > 0.0 || tensioner.mode == TensionerMode::constant;
  law.mode = can_move ? tensioner.mode : TensionerMode::locked;
  law.wanted = tensioner.tension.value_or(static_tension);
  law.low = tensioner.range_low.value_or(0.0);
  law.high = tensioner.range_high.value_or(0.0);
  law.delay = tensioner.delay;
  law.velocity = tensioner.velocity;
  law.acceleration = tensioner.acceleration.value_or(tensioner.velocity / kDefaultAccelerationTime);
  law.limit = tensioner.travel.value_or(std::numeric_limits<double>::infinity());
  law.resolution = kResolution * law.wanted;
  return law;
}

System pipe_system(const Model& model, const StaticSolution& solution, double static_tension) {
  System system;
  Line line = pipe_line(model, solution.mesh, laid_route(model, solution));
  choose_levels(line.yielding, solution.state.q.data());
  // Without the laid pipe added behind the static line, so that the residual does not depend on its length.
  line.name = "pipe";
  line.role = LineRole::pipe;
  line.force_scale = weight_from(line.mesh, line.elements, 0.0);
  const double radius =
      *std::max_element(line.elements.radius.begin(), line.elements.radius.begin() + line.elements.count);
  system.bodies.push_back(vessel_body(model, radius));
  system.lines.push_back(std::move(line));
  system.attachments = {make_anchor_end(model, solution), make_tensioner_end(model, solution, static_tension)};
  system.rub = static_rub(model);
  return system;
}

void set_initial_memories(const Line& line, const StaticSolution& solution, LineState& pipe) {
  if (!solution.bending.empty()) pipe.bending = BendingMemories(solution.bending);
  set_initial_seabed_friction(line, pipe);
}

}  // namespace overbend
