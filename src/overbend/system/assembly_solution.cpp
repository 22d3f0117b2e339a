// What an assembly does with its equations: residual, factors, increments, accelerations.
#include "system/assembly.h"

#include <algorithm>

namespace overbend {

Increments Assembly::increments() const {
  Increments dq;
  for (const LineAssembly& line : lines_) {
    dq.emplace_back(line.residual().size());
  }
  if (!border_.empty()) {
    dq.emplace_back(border_.residual().size());
  }
  return dq;
}

bool Assembly::renew_contacts(const SystemState& state, const Weights& weights) {
  const std::size_t machine = static_cast<std::size_t>(std::max(system_->machine, 0));
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    if (lines_[i].contacts().count() > 0 &&
        (border_.holds_first_end(static_cast<int>(i)) || !lines_[i].renew_contact_tangents(state.lines[i], weights))) {
      return false;
    }
  }
  for (std::size_t i = 0; i < (border_.empty() ? 0 : lines_.size()); ++i) {
    if (lines_[i].contacts().count() > 0) {
      border_.put_line(static_cast<int>(i), lines_[i], state, weights, held_, solver_);
    }
  }
  if (!border_.empty()) {
    border_.put_corner(solver_);
  }
  if (system_->machine >= 0 && governed(machine)) {
    add_governor_tangent(state, weights);
  }
  for (std::size_t i = 0; i < held_.size(); ++i) {
    LineAssembly& line = lines_[static_cast<std::size_t>(system_->attachments[i].line)];
    const int node = line.end_node(system_->attachments[i].end);
    if (line.contacts().count() > 0 && node >= line.kept_from()) {
      line.hold(node, held_[i], true);
    }
  }
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const LineAssembly& line = lines_[i];
    if (line.contacts().count() > 0 && !solver_.factor_line(static_cast<int>(i), line.kept_from()).solved()) {
      return false;
    }
  }
  return solver_.close() < 0;
}

void Assembly::hold(bool with_tangent) {
  for (std::size_t i = 0; i < held_.size(); ++i) {
    LineAssembly& line = lines_[static_cast<std::size_t>(system_->attachments[i].line)];
    line.hold(line.end_node(system_->attachments[i].end), held_[i], with_tangent);
  }
}

double Assembly::relative_residual() {
  double worst = 0.0;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const Unbalance one = lines_[i].unbalance();
    const double relative = one.force / lines_[i].line().force_scale;
    if (i == 0 || relative > worst) {
      worst = relative;
      worst_ = {static_cast<int>(i), one.node};
    }
  }
  for (std::size_t i = 0; i < border_.count(); ++i) {
    const double relative = border_.relative_residual(i);
    if (!(relative <= worst)) {  // NaN too
      worst = relative;
      worst_ = {kBodyPlace, static_cast<int>(i)};
    }
  }
  return worst;
}

void Assembly::point_solution_at(Increments& dq) {
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    solution_[i] = dq[i].data();
  }
}

void Assembly::take_residual(Increments& dq) {
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const std::vector<double>& residual = lines_[i].residual();
    for (std::size_t k = 0; k < residual.size(); ++k) {
      dq[i][k] = -residual[k];
    }
  }
  for (std::size_t k = 0; k < border_.residual().size(); ++k) {
    dq.back()[k] = -border_.residual()[k];
  }
  point_solution_at(dq);
}

bool Assembly::solve_factored(Increments& dq) {
  take_residual(dq);
  return solver_.factor_and_solve(solution_, border_of(dq)).solved();
}

bool Assembly::factor() {
  return solver_.factor().solved();
}

void Assembly::solve_again(Increments& dq) {
  take_residual(dq);
  solver_.solve(solution_, border_of(dq));
}

void Assembly::apply_factors(Increments& dq) {
  point_solution_at(dq);
  solver_.solve(solution_, border_of(dq));
}

void Assembly::hold_body(int body, int freedom, bool held) {
  border_.hold(body, freedom, held);
  solver_.hold(6 * border_.number_of(body) + freedom, held);
}

bool Assembly::find_accelerations(SystemState& state) {
  constexpr double kMassDominates = 1e16;  // weight of the mass at which stiffness is rounding [1/s2]
  const SystemState before = state;
  impose_ends(state);
  evaluate(state, before, {0.0, kMassDominates, 0.0}, true);
  hold(true);
  Increments dq = increments();
  if (!solve_factored(dq)) {
    return false;
  }
  for (std::size_t i = 0; i < state.bodies.size(); ++i) {
    state.bodies[i].acc += kMassDominates * Eigen::Map<const Vec6>(dq.back().data() + 6 * i);
  }
  for (std::size_t i = 0; i < state.lines.size(); ++i) {
    for (std::size_t k = 0; k < dq[i].size(); ++k) {
      state.lines[i].acc[k] += kMassDominates * dq[i][k];
    }
  }
  for (std::size_t i = 0; i < held_.size(); ++i) {
    const Attachment& held = system_->attachments[i];
    const std::size_t line = static_cast<std::size_t>(held.line);
    const double* at = dq[line].data() + 6 * lines_[line].end_node(held.end);
    const auto along = [&](const double* part) {
      return kMassDominates * surroundings_.ends[i].direction.dot(Vec3(Eigen::Map<const Vec3>(part)));
    };
    if (held.hold_direction) {
      state.attachments[i].guide.acc += along(at + 3);
    }
    if (governed(i)) {
      state.attachments[i].travel.acc -= along(at);
    }
  }
  if (!border_.empty()) {
    impose_ends(state);  // with the accelerations of the bodies
  }
  return true;
}

}  // namespace overbend
