#include "statics/static_system.h"

#include <algorithm>
#include <cmath>

#include "statics/step_search.h"
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
  const std::vector<double>& lengths = parts->line.mesh.length;
  const LineElements& elements = parts->line.elements;
  const double radius = *std::max_element(elements.radius.begin(), elements.radius.begin() + elements.count);
  parts->bodies.push_back(vessel_body(model, *std::min_element(lengths.begin(), lengths.end()), radius));
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
  hold_ends(pose);
}

void StaticSystem::hold_ends(const VesselPose& pose) {
  const double far = parts_->line.mesh.total_length();
  far_direction_ = model_->seabed.surface.along(plane_.route.place(far), plane_.route.direction(far));
  held_far_.position = {{plane_.port_W, Vec3::Zero(), Vec3::Zero()}, 1};
  held_far_.tangent = across(far_direction_);
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

void StaticSystem::use_side_rollers(bool use) {
  easing_.rollers.sides = use;
  assembly_.ease(easing_);
}

void StaticSystem::let_yield(double factor) {
  easing_.yielding = factor;
  assembly_.ease(easing_);
}

void StaticSystem::scale_current(double scale) {
  easing_.current = scale;
  assembly_.ease(easing_);
}

void StaticSystem::evaluate(const LineState& state, bool with_tangent) {
  assembly_.evaluate_at_rest(parts_->motions, state, model_->description.statics.history, with_tangent);
  for (int i = 0; i < 3; ++i) {
    assembly_.residual()[static_cast<std::size_t>(i)] -= state.far_force * far_direction_(i);
  }
}

std::vector<BendingMemory> StaticSystem::bending_memory(const LineState& state) {
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

}  // namespace overbend
