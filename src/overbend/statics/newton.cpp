#include "statics/newton.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>

#include "statics/step_search.h"

namespace overbend {
namespace {

constexpr double kLargestForceStep = 0.3;  ///< Of the far force, relative.
constexpr double kLeastFarForce = 1e-6;    ///< Of the total weight: steps leave that much where they go below zero.
constexpr double kBalanced = 1e-6;         ///< Residual of a line that balances, whatever is wanted of it.

/// Where the tangent leaves out that steel remembers what bent it upstream, Newton's steps are those of a fixed-point
/// iteration. What the last of them changed in the next tells what is left out (Anderson 1965, Walker and Ni 2011).
class StepMixing {
 public:
  /// Mixes the last steps into this one; `force` is the step of the far force.
  void mix(std::vector<double>& step, double& force) {
    Eigen::VectorXd now(static_cast<Eigen::Index>(step.size()) + 1);
    now << Eigen::Map<const Eigen::VectorXd>(step.data(), static_cast<Eigen::Index>(step.size())), force;
    if (asked_.size() == now.size() && taken_.size() == now.size()) {
      if (changes_.size() == kMixed) changes_.erase(changes_.begin());
      changes_.push_back({now - asked_, taken_});
    }
    asked_ = now;
    taken_.resize(0);
    if (changes_.empty()) return;
    Eigen::MatrixXd change(now.size(), static_cast<Eigen::Index>(changes_.size()));
    for (std::size_t i = 0; i < changes_.size(); ++i) change.col(static_cast<Eigen::Index>(i)) = changes_[i].asked;
    const Eigen::VectorXd share = change.colPivHouseholderQr().solve(now);
    if ((now - change * share).norm() > kWorthwhile * now.norm()) return;
    for (std::size_t i = 0; i < changes_.size(); ++i) {
      now -= share(static_cast<Eigen::Index>(i)) * (changes_[i].asked + changes_[i].taken);
    }
    Eigen::Map<Eigen::VectorXd>(step.data(), now.size() - 1) = now.head(now.size() - 1);
    force = now(now.size() - 1);
  }
  /// What became of the step mixed last.
  void took(const std::vector<double>& step, double share, double force) {
    taken_.resize(static_cast<Eigen::Index>(step.size()) + 1);
    taken_ << share * Eigen::Map<const Eigen::VectorXd>(step.data(), static_cast<Eigen::Index>(step.size())), force;
  }
  void forget() {
    changes_.clear();
    asked_.resize(0);
    taken_.resize(0);
  }

 private:
  static constexpr std::size_t kMixed = 6;  ///< Steps that are remembered; 3 to 10 solve about as many random lays.
  static constexpr double kWorthwhile =
      0.7;  ///< Share of a step that may stand against those before and still be mixed.
  struct Change {
    Eigen::VectorXd asked, taken;
  };
  std::vector<Change> changes_;
  Eigen::VectorXd asked_, taken_;
};

struct Search {
  StaticSystem& system;
  const LineState& from;
  const std::vector<double>& dq;
  LineState& trial;
  int& trials;

  /// Work of the unbalanced forces per unit of the step at `share`.
  double work_at(double share) {
    ++trials;
    advance(trial, from, dq, share);
    system.evaluate(trial, false);
    system.hold(false);
    return system.work(dq);
  }
};

}  // namespace

double relative_target_error(const StaticSystem& system, const LineState& state, const LineTargetValue& target) {
  const bool tension = target.kind == LineTargetValue::Kind::top_tension;
  const double scale = tension ? std::min(system.total_weight(), target.value) : system.mesh().total_length();
  return std::abs(system.target_error(state, target)) / scale;
}

NewtonReport newton(StaticSystem& system, LineState& state, const LineTargetValue& target,
                    const NewtonSettings& settings) {
  NewtonReport report;
  std::vector<double> dq(state.q.size());
  LineState trial = state;
  StepMixing mixing;
  double damping = 0.0;  // viscous resistance to a step, per length [N/m2]
  const double move = largest_move(system.mesh());
  for (; report.iterations <= settings.max_iterations; ++report.iterations) {
    system.evaluate(state, true);
    system.hold(true);
    report.residual = system.relative_residual();
    if (!std::isfinite(report.residual)) {
      report.end = NewtonEnd::lost;
      return report;
    }
    const double target_error = settings.free_far_force ? relative_target_error(system, state, target) : 0.0;
    if (std::max(report.residual, target_error) < settings.tolerance) {
      report.end = NewtonEnd::converged;
      return report;
    }
    if (state.far_force < kLeastFarForce * system.total_weight() && report.residual < kBalanced) {
      report.end = NewtonEnd::slack;
      return report;
    }
    double dH = 0.0;
    if (!system.solve_step(state, target, damping, settings.free_far_force && damping == 0.0, dq, dH)) {
      if (damping > kMostDamping) {
        report.end = NewtonEnd::singular;
        report.singular_node = system.singular_node();
        return report;
      }
      damping = std::max(kDampingStep * damping, 1e2);
      continue;
    }
    const bool mixes = settings.remembers && damping == 0.0;
    if (mixes) {
      mixing.mix(dq, dH);
    } else {
      mixing.forget();
    }
    const double limit = std::min(step_limit(dq, move), system.share_before_entering(dq, settings.entering));
    double force_step = limit * dH;
    force_step = std::clamp(force_step, -kLargestForceStep * state.far_force, kLargestForceStep * state.far_force);
    trial.far_force = state.far_force + force_step;
    double work_start = system.work(dq);
    for (int i = 0; i < 3; ++i) {
      work_start -= force_step * system.far_direction()(i) * dq[static_cast<std::size_t>(i)];
    }
    if (work_start >= 0.0 &&
        damping < kMostDamping) {  // past a limit point: damped steps lead downhill to where the pipe snaps
      damping = std::max(kDampingStep * damping, 1.0);
      continue;
    }
    Search search{system, state, dq, trial, report.trials};
    const double share = search_along([&](double at) { return search.work_at(at); }, work_start, limit);
    if (mixes) mixing.took(dq, share, force_step);
    if (share < 0.05) {
      damping = std::max(kDampingStep * damping, 1.0);
    } else {
      damping = damping < 1.0 ? 0.0 : damping / kDampingStep;
    }
    std::swap(state, trial);
  }
  report.end = NewtonEnd::too_many_iterations;
  return report;
}

}  // namespace overbend
