#include "statics/solver/newton.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/dense_algebra.h"
#include "statics/equations/step_search.h"

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
    const Eigen::VectorXd share = least_squares(change, now);
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

/// Looks at the unbalanced forces along a step.
struct Search {
  StaticSystem& system;
  const LineState& from;
  const std::vector<double>& dq;
  LineState& trial;
  int& trials;
  bool with_tangent;         ///< Whether the first look takes the tangent along: most steps end there.
  bool has_tangent = false;  ///< Whether the last look did.

  /// Work of the unbalanced forces per unit of the step at `share`.
  double work_at(double share) {
    ++trials;
    advance(trial, from, dq, share);
    has_tangent = std::exchange(with_tangent, false);
    system.evaluate(trial, has_tangent);
    system.hold(has_tangent);
    return system.work(dq);
  }
};

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

}  // namespace

double relative_target_error(const StaticSystem& system, const LineState& state, const LineTargetValue& target) {
  const bool tension = target.kind == LineTargetValue::Kind::top_tension;
  const double scale = tension ? std::min(system.total_weight(), target.value) : system.mesh().total_length();
  return std::abs(system.target_error(state, target)) / scale;
}

namespace {

/// One search for an equilibrium.
class NewtonSearch {
 public:
  NewtonSearch(StaticSystem& system, LineState& state, const LineTargetValue& target, const NewtonSettings& settings)
      : system_(system),
        state_(state),
        target_(target),
        settings_(settings),
        dq_(state.q.size()),
        trial_(state),
        descent_(settings.tolerance),
        move_(largest_move(system.mesh())) {}

  NewtonReport run() {
    for (; report_.iterations <= settings_.max_iterations; ++report_.iterations) {
      if (!looked_) look(true);
      if (ended()) return report_;
      if (!has_tangent_) look(true);
      if (!take_step()) return report_;
    }
    report_.end = NewtonEnd::too_many_iterations;
    return report_;
  }

 private:
  void look(bool with_tangent) {
    system_.evaluate(state_, with_tangent);
    system_.hold(with_tangent);
    looked_ = true;
    has_tangent_ = with_tangent;
  }

  double target_error() const {
    return settings_.free_far_force ? relative_target_error(system_, state_, target_) : 0.0;
  }

  /// Whether there is nothing more to do, or to be done, from the state as it was looked at.
  bool ended() {
    report_.residual = system_.relative_residual();
    const double error = std::max(report_.residual, target_error());
    descent_.reached(error);
    if (!std::isfinite(report_.residual)) {
      report_.end = NewtonEnd::lost;
      return true;
    }
    if (error < settings_.tolerance) {
      report_.end = NewtonEnd::converged;
      return true;
    }
    if (state_.far_force < kLeastFarForce * system_.total_weight() && report_.residual < kBalanced) {
      report_.end = NewtonEnd::slack;
      return true;
    }
    return false;
  }

  /// One step with the tangent of the state, or with more damping where that leads nowhere. False where none is left.
  bool take_step() {
    double dH = 0.0;
    const bool free = settings_.free_far_force && damping_ == 0.0;
    const bool solved = system_.solve_step(state_, target_, damping_, free, dq_, dH);
    looked_ = has_tangent_ = false;
    if (!solved) {
      if (damping_ > kMostDamping) {
        report_.end = NewtonEnd::singular;
        report_.singular_node = system_.singular_node();
        return false;
      }
      damping_ = std::max(kDampingStep * damping_, 1e2);
      return true;
    }
    const bool mixes = settings_.remembers && damping_ == 0.0;
    if (mixes) {
      mixing_.mix(dq_, dH);
    } else {
      mixing_.forget();
    }
    const double limit = std::min(step_limit(dq_, move_), system_.share_before_entering(dq_, settings_.entering));
    const double force_step =
        std::clamp(limit * dH, -kLargestForceStep * state_.far_force, kLargestForceStep * state_.far_force);
    trial_.far_force = state_.far_force + force_step;
    double work_start = system_.work(dq_);
    for (int i = 0; i < 3; ++i) {
      work_start -= force_step * system_.far_direction()(i) * dq_[static_cast<std::size_t>(i)];
    }
    if (work_start >= 0.0 &&
        damping_ < kMostDamping) {  // past a limit point: damped steps lead downhill to where the pipe snaps
      damping_ = std::max(kDampingStep * damping_, 1.0);
      return true;
    }
    search_step(work_start, limit, force_step, mixes);
    return true;
  }

  void search_step(double work_start, double limit, double force_step, bool mixes) {
    const bool tangent = goes_well_ && !descent_.ends_next();
    Search search{system_, state_, dq_, trial_, report_.trials, tangent};
    const double share = search_along([&](double at) { return search.work_at(at); }, work_start, limit);
    if (mixes) mixing_.took(dq_, share, force_step);
    goes_well_ = share == limit;
    if (share < 0.05) {
      damping_ = std::max(kDampingStep * damping_, 1.0);
    } else {
      damping_ = damping_ < 1.0 ? 0.0 : damping_ / kDampingStep;
    }
    std::swap(state_, trial_);
    looked_ = true;
    has_tangent_ = search.has_tangent;
  }

  StaticSystem& system_;
  LineState& state_;
  const LineTargetValue& target_;
  const NewtonSettings& settings_;
  NewtonReport report_;
  std::vector<double> dq_;
  LineState trial_;
  StepMixing mixing_;
  Descent descent_;
  double move_;
  double damping_ = 0.0;      ///< Viscous resistance to a step, per length [N/m2].
  bool looked_ = false;       ///< Whether the system was evaluated at the state.
  bool has_tangent_ = false;  ///< Whether its blocks are those of the state.
  bool goes_well_ = true;     ///< Whether the last step ended at its first look.
};

}  // namespace

NewtonReport newton(StaticSystem& system, LineState& state, const LineTargetValue& target,
                    const NewtonSettings& settings) {
  return NewtonSearch(system, state, target, settings).run();
}

}  // namespace overbend
