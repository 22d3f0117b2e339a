#include "statics/equations/static_system.h"

#include <algorithm>
#include <cmath>

#include "base/interruption.h"
#include "mechanics/ground.h"
#include "mechanics/quadrature.h"
#include "mechanics/rod_element.h"
#include "model/lay_stage.h"
#include "statics/equations/step_search.h"
#include "statics/equations/touchdown.h"
#include "system/vessel_body.h"

namespace overbend {
namespace {

using Vec3Map = Eigen::Map<const Vec3>;

Vec3 position(const std::vector<double>& q, int node) {
  return Vec3(Vec3Map(q.data() + 6 * node));
}
Vec3 tangent_at(const std::vector<double>& q, int node) {
  return Vec3(Vec3Map(q.data() + 6 * node + 3));
}

}  // namespace

bool lays_steadily(const Model& model) {
  const Description& d = model.description;
  return d.statics.laying == Laying::steady && model.seabed.friction_lateral > 0.0 && model.seabed.stiffness > 0.0 &&
         !cable_at_far_end(d);
}

void advance(LineState& to, const LineState& from, const std::vector<double>& dq, double share) {
  to.q.resize(dq.size());
  to.low.resize(dq.size());
  for (std::size_t i = 0; i < dq.size(); ++i) {
    const double step = share * dq[i] + (from.low.empty() ? 0.0 : from.low[i]);
    const double sum = from.q[i] + step;
    const double part = sum - from.q[i];
    to.low[i] = (from.q[i] - (sum - part)) + (step - part);
    to.q[i] = sum;
  }
}

std::unique_ptr<const StaticSystem::Parts> StaticSystem::parts_of(const Model& model, const VesselPose& pose,
                                                                  LineMesh mesh, const LayPlane& plane) {
  auto parts = std::make_unique<Parts>();
  parts->line = pipe_line(model, std::move(mesh), plane.route);
  const LineElements& elements = parts->line.elements;
  const double radius = *std::max_element(elements.radius.begin(), elements.radius.begin() + elements.count);
  parts->bodies.push_back(vessel_body(model, radius));
  parts->motions.push_back(resting(pose));
  return parts;
}

StaticSystem::StaticSystem(const Model& model, const VesselPose& pose, LineMesh mesh)
    : model_(&model),
      pose_(pose),
      plane_(lay_plane(model, pose)),
      parts_(parts_of(model, pose, std::move(mesh), plane_)),
      solver_(std::make_unique<BorderedSystem>(std::vector<BorderedLine>{{parts_->line.mesh.nodes(), {0}}}, 1)),
      assembly_(parts_->line, parts_->bodies, solver_->line(0)) {
  lays_steadily_ = overbend::lays_steadily(model);
  easing_.rollers.rub = static_rub(model);
  assembly_.ease(easing_);
  hold_ends(pose);
}

std::optional<Vec3> StaticSystem::held_far_direction(double distance) const {
  if (cable_at_far_end(model_->description) || model_->seabed.surface.shape() != nullptr) return std::nullopt;
  return model_->seabed.surface.along(plane_.route.place(distance), plane_.route.direction(distance));
}

/// At a distance along the route: across it, and where it lies on the bed in its direction.
void StaticSystem::hold_far_end(double distance) {
  const Vec3 port = plane_.route.port(distance);
  far_direction_ = model_->seabed.surface.along(plane_.route.place(distance), plane_.route.direction(distance));
  held_far_.position = {{port, Vec3::Zero(), Vec3::Zero()}, 1};
  held_far_.tangent = {};
  if (const auto along = held_far_direction(distance)) held_far_.tangent = across(*along);
  if (cable_at_far_end(model_->description)) {
    far_direction_ = plane_.route.direction(distance);
    held_far_.position = {{port, Vec3::UnitZ(), Vec3::Zero()}, 2};
  }
}

/// Where the route bends, its direction at the far end is that of the place; and the pipe lies on the line through it.
void StaticSystem::follow_far_end(const LineState& state) {
  constexpr double kRounding = 1e-9;  // [m] of places: no side load moves the pipe as little
  const Vec3 far = position(state.q, 0);
  if (!plane_.route.straight()) hold_far_end(plane_.route.distance(far));
  if (!lays_steadily_) return;
  const double aside = plane_.route.offset(far);
  assembly_.lay_beside(std::abs(aside) > kRounding ? aside : 0.0);
}

void StaticSystem::hold_ends(const VesselPose& pose) {
  hold_far_end(parts_->line.mesh.total_length());
  held_top_.position = all_directions();
  if (model_->description.tensioner.guide == Guide::clamped) {
    const double incline = model_->description.tensioner.incline;
    guide_ = direction_from_ramp(pose, Vec3(-std::cos(incline), 0.0, std::sin(incline)));
    held_top_.tangent = across(*guide_);
  }
}

void StaticSystem::limit_roller_stiffness(double limit) {
  easing_.rollers.most_stiffness = limit;
  assembly_.ease(easing_);
}

void StaticSystem::limit_bed_stiffness(double limit) {
  easing_.most_bed_stiffness = limit;
  assembly_.ease(easing_);
}

void StaticSystem::scale_bed_relief(double relief, double level) {
  easing_.bed_relief = relief;
  easing_.bed_level = level;
  assembly_.ease(easing_);
}

void StaticSystem::use_side_rollers(bool use) {
  easing_.rollers.sides = use;
  assembly_.ease(easing_);
}

void StaticSystem::let_yield(double factor) {
  easing_.yielding = factor;
  assembly_.ease(easing_);
}

void StaticSystem::rub_across(double factor) {
  easing_.rollers.rub.across = factor;
  assembly_.ease(easing_);
}

void StaticSystem::scale_current(double scale) {
  easing_.current = scale;
  assembly_.ease(easing_);
}

void StaticSystem::evaluate(const LineState& state, bool with_tangent) {
  check_interruption();
  follow_far_end(state);
  evaluate_on_line(state, with_tangent);
}

void StaticSystem::evaluate_on_line(const LineState& state, bool with_tangent) {
  assembly_.evaluate_at_rest(parts_->motions, state, model_->description.statics.history, with_tangent);
  if (environment().bed_shape != nullptr && !cable_at_far_end(model_->description)) turn_far_end(state, with_tangent);
  for (int i = 0; i < 3; ++i) {
    assembly_.residual()[static_cast<std::size_t>(i)] -= state.far_force * far_direction_(i);
  }
}

/// The force at the far end lies in the bed wherever that end lies.
void StaticSystem::turn_far_end(const LineState& state, bool with_tangent) {
  const GroundPoint ground = ground_at(environment(), position(state.q, 0));
  far_direction_ = ground.along_route;
  if (!with_tangent) return;
  const Mat3 turn = along_route_turn(ground);
  double* const diag = tangent().diag(0);
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) diag[i * kRowWidth + k] -= state.far_force * turn(i, k);
  }
}

std::vector<BendingMemory> StaticSystem::bending_memory(const LineState& state) {
  if (!line().yielding.any) return {};
  follow_far_end(state);
  assembly_.evaluate_at_rest(parts_->motions, state, model_->description.statics.history, false, true);
  return yielding_points().memory;
}

Vec3 StaticSystem::end_reaction(int node) const {
  return Vec3(Vec3Map(residual().data() + 6 * node));
}

void StaticSystem::hold(bool with_blocks) {
  assembly_.hold(0, held_far_, with_blocks);
  assembly_.hold(mesh().nodes() - 1, held_top_, with_blocks);
}

double StaticSystem::target_error(const LineState& state, const LineTargetValue& target) const {
  if (target.kind == LineTargetValue::Kind::anchor_distance) {
    return (position(state.q, 0) - plane_.tensioner_W).dot(plane_.astern_W) - target.value;
  }
  const int last = mesh().nodes() - 1;
  const std::size_t e = mesh().length.size() - 1;
  const double z = position(state.q, last).z();
  const double pressure = elements().pressure_constant[e] + elements().pressure_slope[e] * z +
                          elements().pressure_external[e] * std::max(-z, 0.0);
  return elements().EA[e] * (tangent_at(state.q, last).norm() - 1.0) + pressure - target.value;
}

/// K dq - far_direction dH = -R, and the gradient of what is wanted times dq = -its error.
int StaticSystem::put_border(const LineState& state, const LineTargetValue& target) {
  solver_->clear_border(0);
  Vec3 column = -far_direction_;
  for (const Vec3& d : held_far_.position) {
    column -= column.dot(d) * d;
  }
  const bool anchor = target.kind == LineTargetValue::Kind::anchor_distance;
  const int at = anchor ? 0 : mesh().elements();
  const Vec3 row =
      anchor ? plane_.astern_W : Vec3(elements().EA[mesh().length.size() - 1] * tangent_at(state.q, at).normalized());
  for (int i = 0; i < 3; ++i) {
    solver_->columns(0, 0)[i * solver_->stride(0)] = column(i);
    solver_->rows(0, at)[(anchor ? i : 3 + i) * solver_->stride(0)] = row(i);
  }
  return at;
}

bool StaticSystem::solve_step(const LineState& state, const LineTargetValue& target, double damping,
                              bool free_far_force, std::vector<double>& dq, double& dH) {
  add_step_damping(mesh(), damping, tangent());
  const int wanted_at = put_border(state, target);
  solver_->hold(0, !free_far_force);
  std::transform(residual().begin(), residual().end(), dq.begin(), [](double r) { return -r; });
  dH = -target_error(state, target);
  double* const x = dq.data();
  solve_report_ = solver_->factor_and_solve({&x, 1}, &dH);
  if (solve_report_.singular_unknown >= 0) {
    solve_report_.singular_node = wanted_at;
  }
  return solve_report_.solved();
}

bool StaticSystem::factor(const LineState& state, const LineTargetValue& target) {
  put_border(state, target);
  solver_->hold(0, false);
  solve_report_ = solver_->factor();
  line_change_.reset();
  if (solve_report_.solved() && lays_steadily_ && plane_.route.straight()) find_line_change(state);
  return solve_report_.solved();
}

void StaticSystem::solve(std::vector<double>& x, double& y, double miss) {
  double* const unknowns = x.data();
  solver_->solve({&unknowns, 1}, &y);
  if (!line_change_) return;
  const std::size_t first = 6 * static_cast<std::size_t>(landing_element_);
  double found = 0.0;
  for (std::size_t i = 0; i < landing_gradient_.size(); ++i) found += landing_gradient_[i] * x[first + i];
  const double way = (miss - found) / line_change_->miss;
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += way * line_change_->q[i];
  y += way * line_change_->far_force;
}

std::optional<double> StaticSystem::landing_miss(const LineState& state) const {
  const std::optional<LinePlace> place = find_touchdown(*this, state);
  if (!place) return std::nullopt;
  const std::size_t e = static_cast<std::size_t>(place->element);
  const ElementVector q(Eigen::Map<const ElementVector>(state.q.data() + 6 * e));
  return ground_at(environment(), centreline(q, place->xi, mesh().length[e]).r).off_route;
}

/// Where the bed's friction sticks it follows the line by its elastic stretch; exactly as the tangent has it, since a
/// point that is about to slide would tell by a difference what the tangent does not know.
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

/// The far end and the line move aside: what the end alone puts out of balance is differenced, what the line does comes
/// from the law of friction, and the tangent answers. The miss changes with the place that lands, which goes along the
/// pipe as its clearance asks.
void StaticSystem::find_line_change(const LineState& state) {
  constexpr double kAside = 1e-4;  // [m]
  constexpr double kLeast = 1e-9;  // of the way of the line, by which the miss must change
  const std::optional<LinePlace> place = find_touchdown(*this, state);
  if (!place) return;
  const std::size_t e = static_cast<std::size_t>(place->element);
  const double h = mesh().length[e];
  const CentrelinePoint at =
      centreline(ElementVector(Eigen::Map<const ElementVector>(state.q.data() + 6 * e)), place->xi, h);
  const GroundPoint ground = ground_at(environment(), at.r);
  const double falls = ground.normal.dot(at.a);
  if (falls == 0.0) return;
  const Vec3 way = ground.across_route - ground.across_route.dot(at.a) / falls * ground.normal;
  const HermiteValues shape = hermite(place->xi, h);
  landing_element_ = place->element;
  landing_gradient_.assign(12, 0.0);
  for (int j = 0; j < 4; ++j) {
    Eigen::Map<Vec3>(landing_gradient_.data() + 3 * j) = shape.value(j) * way;
  }

  const Vec3 port = held_far_.position.direction[0];
  LineChange change{std::vector<double>(state.q.size(), 0.0)};
  for (const double sign : {-1.0, 1.0}) {
    LineState moved = state;
    Eigen::Map<Vec3>(moved.q.data()) += sign * kAside * port;
    evaluate_on_line(moved, false);
    hold(false);
    for (std::size_t i = 0; i < change.q.size(); ++i) change.q[i] -= sign * residual()[i] / (2.0 * kAside);
  }
  evaluate(state, false);
  add_friction_by_line(state, change.q);
  hold_node(0, held_far_, change.q, nullptr);
  double* const unknowns = change.q.data();
  solver_->solve({&unknowns, 1}, &change.far_force);
  Eigen::Map<Vec3>(change.q.data()) += port;
  change.miss = -1.0;
  for (std::size_t i = 0; i < 12; ++i) change.miss += landing_gradient_[i] * change.q[6 * e + i];
  if (std::abs(change.miss) > kLeast) line_change_ = std::move(change);
}

double StaticSystem::share_before_entering(const std::vector<double>& dq, double depth) const {
  double share = 1.0;
  for (const RollerContact& contact : contacts()) {
    if (!contact.at.found) {
      continue;
    }
    const ElementVector step(Eigen::Map<const ElementVector>(dq.data() + 6 * contact.at.element));
    const double h = mesh().length[static_cast<std::size_t>(contact.at.element)];
    const double deeper = -contact.normal_direction.dot(centreline(step, contact.at.xi, h).r);
    const double allowed = depth + std::max(-contact.penetration, 0.0);
    share = deeper > allowed ? std::min(share, allowed / deeper) : share;
  }
  return share;
}

double StaticSystem::work(const std::vector<double>& dq) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < dq.size(); ++i) {
    sum += residual()[i] * dq[i];
  }
  return sum;
}

ClosestPoint closest_to_roller(const StaticSystem& system, const LineState& state, int roller) {
  const ClosestPoint& met = system.contacts()[static_cast<std::size_t>(roller)].at;
  if (met.found) return met;
  const LineMesh& mesh = system.mesh();
  return closest_point(system.rollers().placed(roller), state.q.data(), mesh.length.data(), 0, mesh.elements());
}

}  // namespace overbend
