// Solution of the assembled equations: residual, factors, increments, accelerations.
#include "system/assembly.h"

#include <algorithm>
#include <limits>

namespace overbend {
namespace {

constexpr int kNotFresh = std::numeric_limits<int>::max();

}  // namespace

Increments Assembly::increments() const {
  Increments dq;
  for (const LineAssembly& line : lines_) {
    dq.emplace_back(line.residual().size());
  }
  if (bordered()) dq.emplace_back(static_cast<std::size_t>(solver_.unknowns()));
  return dq;
}

void Assembly::put_far_force(std::size_t number, const Vec3& column, const TargetEquation& target) {
  const int line = system_->far_forces[number];
  const int border_unknowns = border_.unknowns_of_line(line), stride = solver_.stride(line);
  if (border_unknowns == 0) solver_.clear_border(line);
  for (int i = 0; i < 3; ++i) {
    solver_.columns(line, 0)[i * stride + border_unknowns] = column(i);
    solver_.rows(line, target.node)[((target.tangent ? 3 : 0) + i) * stride + border_unknowns] = target.gradient(i);
  }
  target_errors_[number] = target.error;
}

void Assembly::hold_far_force(std::size_t number, bool held) {
  solver_.hold(far_unknown(number), held);
}

bool Assembly::renew_contacts(const SystemState& state, const Weights& weights) {
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    fresh_from_[i] = kNotFresh;
    if (lines_[i].contacts().count() == 0) continue;
    if (border_.holds_before_last(static_cast<int>(i)) || !lines_[i].renew_contact_tangents(state.lines[i], weights)) {
      return false;
    }
    fresh_from_[i] = lines_[i].kept_from();
  }
  return factor_fresh(state, weights);
}

bool Assembly::renew_lines(SystemState& state, const SystemState& before, const Weights& weights,
                           const std::vector<char>& which) {
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    fresh_from_[i] = which[i] != 0 ? 0 : kNotFresh;
    if (which[i] == 0) continue;
    lines_[i].evaluate(state.lines[i], before.lines[i], weights, surroundings_.water[i], true, ContactMode::free);
    for (const Tensioner& tensioner : tensioners_) {
      const int line = system_->attachments[tensioner.attachment].line;
      if (line == static_cast<int>(i) && is_governed(tensioner)) add_governor(tensioner, state);
    }
  }
  return factor_fresh(state, weights);
}

/// Factors border, governor, held ends and lines whose blocks have been renewed.
bool Assembly::factor_fresh(const SystemState& state, const Weights& weights) {
  const auto fresh = [&](int line) { return fresh_from_[static_cast<std::size_t>(line)] != kNotFresh; };
  const int lines = static_cast<int>(lines_.size());
  bool any = false;
  for (int i = 0; i < lines; ++i) {
    any = any || fresh(i);
    if (fresh(i) && !border_.empty()) {
      border_.put_line(i, line(static_cast<std::size_t>(i)), state, weights, held_, solver_);
    }
  }
  if (!any) return true;
  if (!border_.empty()) {
    border_.put_corner(solver_);
  }
  for (const Tensioner& tensioner : tensioners_) {
    if (is_governed(tensioner) && fresh(system_->attachments[tensioner.attachment].line)) {
      add_governor_tangent(tensioner, state, weights);
    }
  }
  for (std::size_t i = 0; i < held_.size(); ++i) {
    const std::size_t of = static_cast<std::size_t>(system_->attachments[i].line);
    const int node = held_node(system_->attachments[i], system_->lines[of]);
    if (node >= fresh_from_[of]) lines_[of].hold(node, held_[i], true);
  }
  for (int i = 0; i < lines; ++i) {
    if (fresh(i) && !solver_.factor_line(i, fresh_from_[static_cast<std::size_t>(i)]).solved()) return false;
  }
  return solver_.close() < 0;
}

void Assembly::hold_attachment(std::size_t index, bool with_tangent) {
  const Attachment& attachment = system_->attachments[index];
  LineAssembly& line = lines_[static_cast<std::size_t>(attachment.line)];
  line.hold(held_node(attachment, line.line()), held_[index], with_tangent);
}

void Assembly::hold(bool with_tangent) {
  for (std::size_t i = 0; i < held_.size(); ++i) hold_attachment(i, with_tangent);
}

void Assembly::hold_line(int line, bool with_tangent) {
  for (std::size_t i = 0; i < held_.size(); ++i) {
    if (system_->attachments[i].line == line) hold_attachment(i, with_tangent);
  }
}

double Assembly::relative_residual() {
  double worst = 0.0;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const Unbalance line_unbalance = lines_[i].unbalance();
    const double relative = line_unbalance.force / lines_[i].line().force_scale;
    residuals_[i] = relative;
    if (i == 0 || relative > worst) {
      worst = relative;
      worst_ = {static_cast<int>(i), line_unbalance.node};
    }
  }
  for (std::size_t i = 0; i < border_.count(); ++i) {
    const double relative = border_.relative_residual(i);
    residuals_.back() = i == 0 ? relative : std::max(residuals_.back(), relative);
    if (!(relative <= worst)) {  // also true for NaN
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
  for (std::size_t k = 0; k < target_errors_.size(); ++k) {
    dq.back()[static_cast<std::size_t>(far_unknown(k))] = -target_errors_[k];
  }
  point_solution_at(dq);
}

bool Assembly::solve_factored(Increments& dq) {
  take_residual(dq);
  solve_report_ = solver_.factor_and_solve(solution_, border_increments(dq));
  return solve_report_.solved();
}

bool Assembly::solve_line(int index, Increments& dq) {
  const std::vector<double>& residual = line(static_cast<std::size_t>(index)).residual();
  std::vector<double>& x = dq[static_cast<std::size_t>(index)];
  std::transform(residual.begin(), residual.end(), x.begin(), [](double r) { return -r; });
  return solver_.solve_line(index, x.data()).solved();
}

bool Assembly::factor() {
  solve_report_ = solver_.factor();
  return solve_report_.solved();
}

void Assembly::solve_again(Increments& dq) {
  take_residual(dq);
  solver_.solve(solution_, border_increments(dq));
}

void Assembly::apply_factors(Increments& dq) {
  point_solution_at(dq);
  solver_.solve(solution_, border_increments(dq));
}

void Assembly::hold_body(int body, int freedom, bool held) {
  border_.hold(body, freedom, held);
  solver_.hold(6 * border_.free_body_number(body) + freedom, held);
}

bool Assembly::find_accelerations(SystemState& state) {
  constexpr double kMassDominates = 1e16;  // weight of the mass that makes the stiffness negligible [1/s2]
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
    const double* values = dq[line].data() + 6 * held_node(held, system_->lines[line]);
    const auto along = [&](const double* part) {
      return kMassDominates * surroundings_.ends[i].direction.dot(Vec3(Eigen::Map<const Vec3>(part)));
    };
    if (held.hold_direction) {
      state.attachments[i].guide.acc += along(values + 3);
    }
    if (governed(i)) {
      state.attachments[i].travel.acc -= along(values);
    }
  }
  if (!border_.empty()) {
    impose_ends(state);  // with the accelerations of the bodies
  }
  return true;
}

}  // namespace overbend
