#include "statics/equations/static_system.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mechanics/ground.h"
#include "mechanics/quadrature.h"
#include "mechanics/rod_element.h"
#include "statics/equations/touchdown.h"
#include "system/vessel_body.h"

namespace overbend {
namespace {

constexpr std::size_t kFar = 0, kTop = 1;  ///< Indices of attachments.

std::optional<Vec3> guide_direction(const Model& model, const VesselPose& pose) {
  if (model.description.tensioner.guide != Guide::clamped) return std::nullopt;
  const double incline = model.description.tensioner.incline;
  return direction_from_ramp(pose, Vec3(-std::cos(incline), 0.0, std::sin(incline)));
}

Attachment top_end(bool guided) {
  Attachment top;
  top.end = LineEnd::last;
  top.body = 0;
  top.hold_place = true;
  top.hold_direction = guided;
  return top;
}

System lay_system(const Model& model, const VesselPose& pose, const std::optional<Vec3>& guide, LineMesh mesh,
                  const LayRoute& route) {
  System system;
  system.lines.push_back(pipe_line(model, std::move(mesh), route));
  const LineElements& elements = system.lines.front().elements;
  const double radius = *std::max_element(elements.radius.begin(), elements.radius.begin() + elements.count);
  system.bodies.push_back(vessel_body(model, radius));
  system.attachments = {Attachment{}, top_end(guide.has_value())};
  system.far_forces = {0};
  system.surroundings = [vessel = resting(pose), guide](double, Surroundings& surroundings) {
    surroundings.bodies[kVessel] = vessel;
    if (guide) surroundings.ends[kTop].direction = *guide;
  };
  return system;
}

}  // namespace

StaticSystem::Parts::Parts(const Model& model, const VesselPose& pose, const std::optional<Vec3>& guide, LineMesh mesh)
    : plane(lay_plane(model, pose)),
      system(lay_system(model, pose, guide, std::move(mesh), plane.route)),
      assembly(system),
      far_end(model, plane.route, system.lines.front().mesh.total_length()),
      equilibrium(assembly, {model.description.statics.history}) {
  assembly.set_surroundings(0.0);
  equilibrium.slide(far_end, kFar, plane);
  complete_state.lines.resize(1);
}

StaticSystem::StaticSystem(const Model& model, const VesselPose& pose, LineMesh mesh)
    : model_(&model),
      pose_(pose),
      guide_(guide_direction(model, pose)),
      parts_(std::make_unique<Parts>(model, pose, guide_, std::move(mesh))) {
  Continuation continuation;
  continuation.roller_friction = static_rub(model);
  set(continuation);
}

SystemState& StaticSystem::complete_state(const LineState& state) {
  LineState& pipe = parts_->complete_state.lines.front();
  pipe.q = state.q;
  pipe.low = state.low;
  pipe.far_force = state.far_force;
  return parts_->complete_state;
}

void StaticSystem::evaluate(const LineState& state, bool with_tangent) {
  parts_->equilibrium.evaluate(complete_state(state), with_tangent);
}

std::vector<BendingMemory> StaticSystem::bending_memory(const LineState& state) {
  if (!line().yielding.any) return {};
  parts_->far_end.update(state, pipe());
  pipe().evaluate_at_rest(parts_->assembly.surroundings().bodies, state, model_->description.statics.history, false,
                          true);
  return yielding_points().memory;
}

Vec3 StaticSystem::end_reaction(int node) const {
  return Vec3(Eigen::Map<const Vec3>(residual().data() + 6 * node));
}

double StaticSystem::target_error(const LineState& state, const EquilibriumTarget& target) const {
  return target_equation(target, plane(), line(), state).error;
}

bool StaticSystem::factor(const LineState& state, const EquilibriumTarget& target) {
  parts_->equilibrium.put_target(target, complete_state(state));
  parts_->assembly.hold_far_force(0, false);
  const bool solved = parts_->assembly.factor();
  line_change_.reset();
  if (solved && lays_steadily() && plane().route.straight()) find_line_change(state);
  return solved;
}

void StaticSystem::solve(std::vector<double>& x, double& y, double miss) {
  Increments change{std::move(x), {y}};
  parts_->assembly.apply_factors(change);
  x = std::move(change.front());
  y = change.back().front();
  if (!line_change_) return;
  const std::size_t first = 6 * static_cast<std::size_t>(landing_element_);
  double found = 0.0;
  for (std::size_t i = 0; i < landing_gradient_.size(); ++i) found += landing_gradient_[i] * x[first + i];
  const double shift = (miss - found) / line_change_->miss;
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += shift * line_change_->q[i];
  y += shift * line_change_->far_force;
}

std::optional<double> StaticSystem::landing_miss(const LineState& state) const {
  const std::optional<ElementPlace> place = find_touchdown(*this, state);
  if (!place) return std::nullopt;
  const std::size_t e = static_cast<std::size_t>(place->element);
  const ElementVector q(Eigen::Map<const ElementVector>(state.q.data() + 6 * e));
  return ground_at(environment(), centreline(q, place->xi, mesh().length[e]).r).off_route;
}

/// Adds the change of sticking bed friction with the offset of the line, by its elastic stretch. Exactly as in the
/// tangent, since a finite difference at a point about to slide would contain a change that the tangent does not.
void StaticSystem::add_friction_by_line(const LineState& state, std::vector<double>& forces) const {
  const LineEnvironment& env = environment();
  for (std::size_t e = 0; e < mesh().length.size(); ++e) {
    const double h = mesh().length[e];
    const ElementVector q(Eigen::Map<const ElementVector>(state.q.data() + 6 * e));
    for (int point = 0; point < kGaussPoints; ++point) {
      const GroundPoint ground = ground_at(env, centreline(q, kGaussXi[point], h).r);
      const double normal = env.bed_stiffness * (elements().radius[e] - ground.clearance);
      const bool sticks =
          normal > 0.0 && env.bed_stick * std::abs(ground.off_route) <= env.bed_friction_lateral * normal;
      if (!sticks) continue;
      const HermiteValues n = hermite(kGaussXi[point], h);
      for (int j = 0; j < 4; ++j) {
        Eigen::Map<Vec3> force(forces.data() + 6 * e + 3 * static_cast<std::size_t>(j));
        force += n.value(j) * kGaussWeight[point] * h * env.bed_stick * ground.across_route;
      }
    }
  }
}

/// Moves the far end and the line aside. The imbalance due to the end is computed by finite differences, that due to
/// the line from the friction law, and the response from the tangent. The miss changes with the landing place, which
/// moves along the pipe with its clearance.
void StaticSystem::find_line_change(const LineState& state) {
  constexpr double kAside = 1e-4;      // [m]
  constexpr double kMinChange = 1e-9;  // minimum change of the miss relative to the offset of the line
  const std::optional<ElementPlace> place = find_touchdown(*this, state);
  if (!place) return;
  const std::size_t e = static_cast<std::size_t>(place->element);
  const double h = mesh().length[e];
  const CentrelinePoint point =
      centreline(ElementVector(Eigen::Map<const ElementVector>(state.q.data() + 6 * e)), place->xi, h);
  const GroundPoint ground = ground_at(environment(), point.r);
  const double falls = ground.normal.dot(point.a);
  if (falls == 0.0) return;
  const Vec3 direction = ground.across_route - ground.across_route.dot(point.a) / falls * ground.normal;
  const HermiteValues shape = hermite(place->xi, h);
  landing_element_ = place->element;
  landing_gradient_.assign(12, 0.0);
  for (int j = 0; j < 4; ++j) {
    Eigen::Map<Vec3>(landing_gradient_.data() + 3 * j) = shape.value(j) * direction;
  }

  const Vec3 port = parts_->far_end.held().position.direction[0];
  LineChange change{std::vector<double>(state.q.size(), 0.0)};
  for (const double sign : {-1.0, 1.0}) {
    LineState moved = state;
    Eigen::Map<Vec3>(moved.q.data()) += sign * kAside * port;
    parts_->equilibrium.evaluate_forces(complete_state(moved), false);
    hold(false);
    for (std::size_t i = 0; i < change.q.size(); ++i) change.q[i] -= sign * residual()[i] / (2.0 * kAside);
  }
  evaluate(state, false);
  add_friction_by_line(state, change.q);
  hold_node(0, parts_->far_end.held(), change.q, nullptr);
  solve(change.q, change.far_force);
  Eigen::Map<Vec3>(change.q.data()) += port;
  change.miss = -1.0;
  for (std::size_t i = 0; i < 12; ++i) change.miss += landing_gradient_[i] * change.q[6 * e + i];
  if (std::abs(change.miss) > kMinChange) line_change_ = std::move(change);
}

ClosestPoint closest_to_roller(const StaticSystem& system, const LineState& state, int roller) {
  const ClosestPoint& met = system.contacts()[static_cast<std::size_t>(roller)].closest;
  if (met.found) return met;
  const LineMesh& mesh = system.mesh();
  return closest_point(system.rollers().placed(roller), state.q.data(), mesh.length.data(), 0, mesh.elements());
}

}  // namespace overbend
