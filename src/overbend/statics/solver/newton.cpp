#include "statics/solver/newton.h"

#include <algorithm>
#include <cmath>

#include "statics/equations/step_search.h"
#include "statics/solver/step_mixing.h"

namespace overbend {
namespace {

constexpr double kLargestForceStep = 0.3;  ///< Of the far force, relative.
constexpr double kLeastFarForce = 1e-6;    ///< Of the total weight: steps leave that much where they go below zero.
constexpr double kBalanced = 1e-6;         ///< Residual of a line that balances, whatever the target.
constexpr double kBeyondAll = 1e30;        ///< Residual of a state that is lost.
constexpr int kHalvings = 8;               ///< Of a step whose residual grows.

/// Residuals of the last two states, which tell where Newton's method goes from here.
class Descent {
 public:
  explicit Descent(double tolerance) : tolerance_(tolerance) {}
  void reached(double error) {
    before_ = now_;
    now_ = error;
  }
  /// Whether the state after the next step, which squares the residual, is likely to be the last and to need no
  /// tangent.
  bool ends_next() const { return now_ * (now_ / before_) * (now_ / before_) < tolerance_; }

 private:
  double tolerance_;
  double before_ = 0.0, now_ = 0.0;  ///< None yet: no quotient of these is small.
};

/// One search for an equilibrium.
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
      if (!looked_) look(state_, true);
      if (ended()) return report_;
      if (!has_tangent_) look(state_, true);
      if (!take_step()) return report_;
    }
    report_.end = NewtonEnd::too_many_iterations;
    return report_;
  }

 private:
  void look(SystemState& at, bool with_tangent) {
    equations_.evaluate(at, with_tangent);
    equations_.hold(with_tangent);
    looked_ = true;
    has_tangent_ = with_tangent;
  }

  double target_error() const {
    if (!settings_.target) return 0.0;
    return relative_error(*settings_.target, equations_.line().line(),
                          equations_.target_equation(*settings_.target, state_).error);
  }

  bool is_slack() const {
    return settings_.target && report_.residual < kBalanced &&
           equations_.far_force(state_) < kLeastFarForce * equations_.line().line().force_scale;
  }

  bool end(NewtonEnd how) {
    report_.end = how;
    return true;
  }

  /// Whether there is nothing more to do, or to be done, from the state as it was looked at.
  bool ended() {
    report_.residual = equations_.relative_residual();
    const double error = std::max(report_.residual, target_error());
    descent_.reached(error);
    if (!(report_.residual < kBeyondAll)) return end(NewtonEnd::lost);
    if (error < settings_.tolerance) return end(NewtonEnd::converged);
    return is_slack() && end(NewtonEnd::slack);
  }

  bool damped() const { return settings_.search == StepSearch::least_work; }

  bool raise_damping(double least) {
    damping_ = std::max(kDampingStep * damping_, least);
    return true;
  }

  /// One step with the tangent of the state, or with more damping where that leads nowhere. False where none is left.
  bool take_step() {
    const bool free = settings_.target && damping_ == 0.0;
    if (settings_.target) equations_.put_target(*settings_.target, state_);
    const bool solved = equations_.solve(damping_, free, dq_);
    looked_ = has_tangent_ = false;
    if (!solved) {
      if (damped() && damping_ <= kMostDamping) return raise_damping(settings_.singular_damping);
      report_.end = NewtonEnd::singular;
      report_.singular_node = equations_.singular_node();
      return false;
    }
    if (damped()) return step_downhill();
    step_bounded(equations_.body_limit(dq_, settings_.body_step));
    return true;
  }

  bool step_downhill() {
    const bool mixes = settings_.remembers && damping_ == 0.0;
    if (mixes) {
      mixing_.mix(dq_.front(), dq_.back().back());
    } else {
      mixing_.forget();
    }
    const double limit = std::min(equations_.step_limit(dq_, settings_.body_step),
                                  equations_.share_before_entering(dq_, settings_.entering));
    const double force_step = far_force_step(limit);
    const double work_start = equations_.work(dq_, force_step);
    if (work_start >= 0.0 && damping_ < kMostDamping) {
      return raise_damping(1.0);  // past a limit point: damped steps lead downhill to where the pipe snaps
    }
    search_least_work(work_start, limit, force_step);
    if (mixes) mixing_.took(dq_.front(), share_, force_step);
    return true;
  }

  /// Step of the far force, within bounds.
  double far_force_step(double limit) {
    if (!settings_.target) return 0.0;
    const double most = kLargestForceStep * equations_.far_force(state_);
    return std::clamp(limit * dq_.back().back(), -most, most);
  }

  /// Most steps end at the first look, which takes the tangent along.
  void search_least_work(double work_start, double limit, double force_step) {
    bool with_tangent = goes_well_ && !descent_.ends_next();
    const auto work_at = [&](double share) {
      ++report_.trials;
      equations_.advance(trial_, state_, dq_, share);
      if (!state_.lines.empty()) equations_.far_force(trial_) = equations_.far_force(state_) + force_step;
      look(trial_, std::exchange(with_tangent, false));
      return equations_.work(dq_);
    };
    share_ = search_along(work_at, work_start, limit);
    goes_well_ = share_ == limit;
    if (share_ < 0.05) {
      raise_damping(1.0);
    } else {
      damping_ = damping_ < 1.0 ? 0.0 : damping_ / kDampingStep;
    }
    std::swap(state_, trial_);
  }

  /// The far force stays.
  void step_bounded(double limit) {
    const auto grows = [&](double share) {
      equations_.advance(trial_, state_, dq_, share);
      look(trial_, false);
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
  double damping_ = 0.0;      ///< Viscous resistance to a step, per length [N/m2].
  double share_ = 0.0;        ///< Of the last step that was taken.
  bool looked_ = false;       ///< Whether the system was evaluated at the state.
  bool has_tangent_ = false;  ///< Whether its blocks are those of the state.
  bool goes_well_ = true;     ///< Whether the last step ended at its first look.
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
