#include "statics/solver/newton.h"

#include <algorithm>
#include <cmath>

#include "statics/equations/step_search.h"
#include "statics/solver/step_mixing.h"

namespace overbend {
namespace {

constexpr double kMaxForceStep = 0.3;   ///< Maximum relative step of the far force.
constexpr double kMinFarForce = 1e-6;   ///< Relative to the total weight: far force kept if a step would make it
                                        ///< negative.
constexpr double kBalanced = 1e-6;      ///< Residual of a line in equilibrium, for any target.
constexpr double kLostResidual = 1e30;  ///< Residual above which a state is lost.
constexpr int kHalvings = 8;            ///< Halvings of a step whose residual grows.

/// Residuals of the last two states, from which the next one is predicted.
class Descent {
 public:
  explicit Descent(double tolerance) : tolerance_(tolerance) {}
  void reached(double error) {
    before_ = last_;
    last_ = error;
  }
  /// True if the next step, which squares the residual, is likely to be the last and to need no tangent.
  bool ends_next() const { return last_ * (last_ / before_) * (last_ / before_) < tolerance_; }

 private:
  double tolerance_;
  double before_ = 0.0, last_ = 0.0;  ///< None yet: no quotient of these is small.
};

/// Search for an equilibrium.
class NewtonSearch {
 public:
  NewtonSearch(Equilibrium& equations, SystemState& state, const NewtonSettings& settings)
      : equations_(equations),
        state_(state),
        settings_(settings),
        dq_(equations.increments()),
        trial_(state),
        descent_(settings.tolerance) {}

  NewtonReport run() {
    for (; report_.iterations <= settings_.max_iterations; ++report_.iterations) {
      if (!is_evaluated_) evaluate_state(state_, true);
      if (ended()) return report_;
      if (!has_tangent_) evaluate_state(state_, true);
      if (!take_step()) return report_;
    }
    report_.end = NewtonEnd::too_many_iterations;
    return report_;
  }

 private:
  void evaluate_state(SystemState& state, bool with_tangent) {
    equations_.evaluate(state, with_tangent);
    equations_.hold(with_tangent);
    is_evaluated_ = true;
    has_tangent_ = with_tangent;
  }

  double target_error() const {
    if (!settings_.target) return 0.0;
    return relative_error(*settings_.target, equations_.line().line(),
                          equations_.target_equation(*settings_.target, state_).error);
  }

  bool is_slack() const {
    return settings_.target && report_.residual < kBalanced &&
           equations_.far_force(state_) < kMinFarForce * equations_.line().line().force_scale;
  }

  bool end(NewtonEnd how) {
    report_.end = how;
    return true;
  }

  /// Tests convergence and failure at the evaluated state.
  bool ended() {
    report_.residual = equations_.relative_residual();
    const double error = std::max(report_.residual, target_error());
    descent_.reached(error);
    if (!(report_.residual < kLostResidual)) return end(NewtonEnd::lost);
    if (error < settings_.tolerance) return end(NewtonEnd::converged);
    return is_slack() && end(NewtonEnd::slack);
  }

  bool damped() const { return settings_.search == StepSearch::min_work; }

  bool raise_damping(double min_damping) {
    damping_ = std::max(kDampingStep * damping_, min_damping);
    return true;
  }

  /// Takes one step with the tangent of the state, or increases the damping if that fails. Returns false if no step is
  /// left.
  bool take_step() {
    const bool free = settings_.target && damping_ == 0.0;
    if (settings_.target) equations_.put_target(*settings_.target, state_);
    const bool solved = equations_.solve(damping_, free, dq_);
    is_evaluated_ = has_tangent_ = false;
    if (!solved) {
      if (damped() && damping_ <= kMaxDamping) return raise_damping(settings_.singular_damping);
      report_.end = NewtonEnd::singular;
      report_.singular_node = equations_.singular_node();
      return false;
    }
    if (damped()) return step_downhill();
    step_bounded(equations_.body_limit(dq_, settings_.body_step));
    return true;
  }

  bool step_downhill() {
    const bool mixes = settings_.has_plastic_memory && damping_ == 0.0;
    if (mixes) {
      mixing_.mix(dq_.front(), dq_.back().back());
    } else {
      mixing_.forget();
    }
    const double limit = std::min(equations_.step_limit(dq_, settings_.body_step),
                                  equations_.share_before_entering(dq_, settings_.max_entering));
    const double force_step = far_force_step(limit);
    const double work_start = equations_.work(dq_, force_step);
    if (work_start >= 0.0 && damping_ < kMaxDamping) {
      return raise_damping(1.0);  // past a limit point: damped steps lead downhill to the snapped position
    }
    search_min_work(work_start, limit, force_step);
    if (mixes) mixing_.record_taken(dq_.front(), share_, force_step);
    return true;
  }

  /// Step of the far force, within bounds.
  double far_force_step(double limit) {
    if (!settings_.target) return 0.0;
    const double max_step = kMaxForceStep * equations_.far_force(state_);
    return std::clamp(limit * dq_.back().back(), -max_step, max_step);
  }

  /// Most line searches end at their first evaluation, which includes the tangent.
  void search_min_work(double work_start, double limit, double force_step) {
    bool with_tangent = full_step_taken_ && !descent_.ends_next();
    const auto work_at = [&](double share) {
      ++report_.trials;
      equations_.advance(trial_, state_, dq_, share);
      if (!state_.lines.empty()) equations_.far_force(trial_) = equations_.far_force(state_) + force_step;
      evaluate_state(trial_, std::exchange(with_tangent, false));
      return equations_.work(dq_);
    };
    share_ = search_along(work_at, work_start, limit);
    full_step_taken_ = share_ == limit;
    if (share_ < 0.05) {
      raise_damping(1.0);
    } else {
      damping_ = damping_ < 1.0 ? 0.0 : damping_ / kDampingStep;
    }
    std::swap(state_, trial_);
  }

  /// Step with bounded residual; the far force is constant.
  void step_bounded(double limit) {
    const auto grows = [&](double share) {
      equations_.advance(trial_, state_, dq_, share);
      evaluate_state(trial_, false);
      return !(equations_.relative_residual() < settings_.max_growth * report_.residual);
    };
    double share = limit;
    for (int i = 0; grows(share) && i < kHalvings; ++i) share *= 0.5;
    std::swap(state_, trial_);
  }

  Equilibrium& equations_;
  SystemState& state_;
  const NewtonSettings& settings_;
  NewtonReport report_;
  Increments dq_;
  SystemState trial_;
  StepMixing mixing_;
  Descent descent_;
  double damping_ = 0.0;         ///< Viscous damping of a step, per length [N/m2].
  double share_ = 0.0;           ///< Share of the last step that was taken.
  bool is_evaluated_ = false;    ///< True if the system was evaluated at the state.
  bool has_tangent_ = false;     ///< True if its tangent is that of the state.
  bool full_step_taken_ = true;  ///< True if the last search ended at its first evaluation.
};

}  // namespace

NewtonReport solve_equilibrium(Equilibrium& equilibrium, SystemState& state, const NewtonSettings& settings) {
  return NewtonSearch(equilibrium, state, settings).run();
}

NewtonReport solve_equilibrium(StaticSystem& system, LineState& pipe, const NewtonSettings& settings) {
  SystemState state;
  state.lines.push_back(std::move(pipe));
  const NewtonReport report = solve_equilibrium(system.equilibrium(), state, settings);
  pipe = std::move(state.lines.front());
  return report;
}

}  // namespace overbend
