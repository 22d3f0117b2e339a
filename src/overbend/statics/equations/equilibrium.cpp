#include "statics/equations/equilibrium.h"

#include <algorithm>

#include "base/interruption.h"
#include "mechanics/rod_element.h"
#include "statics/equations/step_search.h"

namespace overbend {
namespace {

double product(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

double entering_share(const LineAssembly& line, const std::vector<double>& dq, double depth) {
  double share = 1.0;
  for (const RollerContact& contact : line.contacts().contacts()) {
    if (!contact.closest.found) continue;
    const auto e = static_cast<std::size_t>(contact.closest.element);
    const ElementVector step(Eigen::Map<const ElementVector>(dq.data() + 6 * e));
    const double deeper =
        -contact.normal_direction.dot(centreline(step, contact.closest.xi, line.line().mesh.length[e]).r);
    const double allowed = depth + std::max(-contact.penetration, 0.0);
    share = deeper > allowed ? std::min(share, allowed / deeper) : share;
  }
  return share;
}

void move_by(MotionValues& values, double step, double start, double rate) {
  values.q += step;
  values.v = rate * (values.q - start);
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

Equilibrium::Equilibrium(Assembly& assembly, const EquilibriumRule& rule, int only)
    : assembly_(&assembly),
      rule_(rule),
      only_(only),
      first_(only < 0 ? 0 : static_cast<std::size_t>(only)),
      last_(only < 0 ? assembly.system().lines.size() : first_ + 1),
      line_(first_) {}

void Equilibrium::slide(FarEnd& end, std::size_t attachment, const LayPlane& plane) {
  far_end_ = &end;
  far_attachment_ = attachment;
  plane_ = &plane;
  line_ = static_cast<std::size_t>(assembly_->system().far_forces.front());
  assembly_->hold_end(attachment, end.held());
}

/// Velocities of the step in which friction is mobilised.
void Equilibrium::set_rates(SystemState& state) const {
  if (rule_.laid == nullptr) return;
  for (std::size_t line = first_; line < last_; ++line) {
    LineState& to = state.lines[line];
    const std::vector<double>& from = rule_.laid->lines[line].q;
    for (std::size_t i = 0; i < from.size(); ++i) to.v[i] = (to.q[i] - from[i]) / rule_.duration;
  }
}

void Equilibrium::evaluate_line(SystemState& state, bool with_tangent) {
  static const std::vector<double> kCalm;
  LineAssembly& line = assembly_->line(first_);
  if (rule_.laid == nullptr) {
    line.evaluate_at_rest(assembly_->surroundings().bodies, state.lines[first_], rule_.history, with_tangent);
    return;
  }
  set_rates(state);
  line.evaluate(state.lines[first_], rule_.laid->lines[first_], {1.0 / rule_.duration, 0.0, rule_.duration}, kCalm,
                with_tangent, ContactMode::free);
}

void Equilibrium::evaluate(SystemState& state, bool with_tangent) {
  check_interruption();
  if (moves_ends()) {
    set_rates(state);
    assembly_->set_time(state.time, state);
    assembly_->impose_ends(state);
  }
  if (far_end_ != nullptr) {
    far_end_->update(state.lines[line_], assembly_->line(line_));
    assembly_->hold_end(far_attachment_, far_end_->held());
  }
  evaluate_forces(state, with_tangent);
}

void Equilibrium::evaluate_forces(SystemState& state, bool with_tangent) {
  if (only_ != kAllLines) {
    evaluate_line(state, with_tangent);
  } else if (rule_.laid != nullptr) {
    assembly_->evaluate(state, *rule_.laid, {1.0 / rule_.duration, 0.0, rule_.duration}, with_tangent);
  } else {
    assembly_->evaluate_at_rest(state, rule_.history, with_tangent);
  }
  if (far_end_ != nullptr) far_end_->add_force(state.lines[line_], with_tangent, assembly_->line(line_));
}

void Equilibrium::hold(bool with_tangent) {
  if (only_ == kAllLines) {
    assembly_->hold(with_tangent);
  } else {
    assembly_->hold_line(only_, with_tangent);
  }
}

double Equilibrium::relative_residual() {
  if (only_ == kAllLines) return assembly_->relative_residual();
  return line().unbalance().force / line().line().force_scale;
}

TargetEquation Equilibrium::target_equation(const EquilibriumTarget& target, const SystemState& state) const {
  return overbend::target_equation(target, *plane_, line().line(), state.lines[line_]);
}

void Equilibrium::put_target(const EquilibriumTarget& target, const SystemState& state) {
  const TargetEquation equation = target_equation(target, state);
  assembly_->put_far_force(0, far_end_->column(), equation);
  target_node_ = equation.node;
}

int Equilibrium::singular_node() const {
  const BorderedReport& report = assembly_->solve_report();
  return report.singular_unknown < 0 ? report.singular_node : target_node_;
}

bool Equilibrium::solve(double damping, bool free_far_force, Increments& dq) {
  for (std::size_t i = first_; i < last_; ++i) {
    LineAssembly& line = assembly_->line(i);
    add_step_damping(line.line().mesh, damping, line.tangent());
  }
  if (only_ != kAllLines) return assembly_->solve_line(only_, dq);
  if (far_end_ != nullptr) assembly_->hold_far_force(0, !free_far_force);
  if (!assembly_->solve_factored(dq)) return false;
  if (!moves_ends()) return true;
  directions_.clear();
  for (const EndMotion& end : assembly_->surroundings().ends) directions_.push_back(end.direction);
  return true;
}

double Equilibrium::step_limit(const Increments& dq, const BodyStep& of_bodies) const {
  double share = body_limit(dq, of_bodies);
  for (std::size_t i = first_; i < last_; ++i) {
    share = std::min(share, overbend::step_limit(dq[i], max_node_move(assembly_->line(i).line().mesh)));
  }
  return share;
}

double Equilibrium::body_limit(const Increments& dq, const BodyStep& max_step) const {
  double share = 1.0;
  for (std::size_t i = 0; i < assembly_->free_bodies(); ++i) {
    const Vec6 dh = Eigen::Map<const Vec6>(dq.back().data() + 6 * i);
    share = std::min({share, max_step.move / std::max(dh.head<3>().norm(), 1e-300),
                      max_step.turn / std::max(dh.tail<3>().norm(), 1e-300)});
  }
  return share;
}

double Equilibrium::share_before_entering(const Increments& dq, double depth) const {
  double share = 1.0;
  for (std::size_t i = first_; i < last_; ++i) {
    share = std::min(share, entering_share(assembly_->line(i), dq[i], depth));
  }
  return share;
}

void Equilibrium::advance(SystemState& to, const SystemState& from, const Increments& dq, double share) const {
  if (moves_ends()) to = from;
  for (std::size_t i = first_; i < last_; ++i) overbend::advance(to.lines[i], from.lines[i], dq[i], share);
  if (!moves_ends()) return;
  const SystemState& laid = rule_.laid == nullptr ? from : *rule_.laid;
  const double rate = rule_.laid == nullptr ? 0.0 : 1.0 / rule_.duration;
  for (std::size_t i = 0; i < to.bodies.size(); ++i) {
    to.bodies[i].h += share * Eigen::Map<const Vec6>(dq.back().data() + 6 * i);
    to.bodies[i].v = rate * (to.bodies[i].h - laid.bodies[i].h);
  }
  for (std::size_t i = 0; i < to.attachments.size(); ++i) {
    const Attachment& held = assembly_->system().attachments[i];
    const auto line = static_cast<std::size_t>(held.line);
    const double* part = dq[line].data() + 6 * held_node(held, assembly_->system().lines[line]);
    const auto along = [&](const double* d) { return share * directions_[i].dot(Vec3(Eigen::Map<const Vec3>(d))); };
    move_by(to.attachments[i].guide, along(part + 3), laid.attachments[i].guide.q, rate);
    if (!held.tensioner) continue;
    move_by(to.attachments[i].travel, -along(part), laid.attachments[i].travel.q, rate);
  }
}

double Equilibrium::work(const Increments& dq, double more_far_force) const {
  double sum = 0.0;
  for (std::size_t i = first_; i < last_; ++i) sum += product(assembly_->line(i).residual(), dq[i]);
  if (far_end_ != nullptr) {
    for (int i = 0; i < 3; ++i) {
      sum -= more_far_force * far_end_->direction()(i) * dq[line_][static_cast<std::size_t>(i)];
    }
  }
  return only_ == kAllLines && assembly_->free_bodies() > 0 ? sum + product(assembly_->body_residual(), dq.back())
                                                            : sum;
}

}  // namespace overbend
