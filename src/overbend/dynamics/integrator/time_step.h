/// Time step of a system: generalized-alpha with Newton's method.
#pragma once

#include "dynamics/integrator/step_error.h"
#include "dynamics/integrator/step_prediction.h"
#include "dynamics/machines/end_payout.h"
#include "system/assembly.h"

namespace overbend {

/// Settings of the time step.
struct StepSettings {
  double spectral_radius = 0.6;
  double tolerance = 1e-6;  ///< Maximum unbalanced nodal force over the force scale.
  int max_iterations = 12;
  double short_element = 5.0;  ///< Errors of moorings are reduced at longer elements, see StepError [m].
};

/// Result of the iteration of a step.
enum class StepStatus { converged, too_many_iterations, singular, lost };

/// Convergence of a step.
struct StepReport {
  StepStatus end = StepStatus::too_many_iterations;
  int iterations = 0;
  int factorisations = 0;
  double residual = 0.0;
  std::pair<int, int> worst_place{0, 0};  ///< Line and node with the largest residual.
  bool converged() const { return end == StepStatus::converged; }
};

/// Takes steps and keeps the factors of the last tangent as long as step size, contacts and convergence allow.
class TimeStepper {
 public:
  TimeStepper(Assembly& assembly, const StepSettings& settings);

  /// Steps from `start` over `h` to `next`, where the system is left evaluated. If it fails, `next` is invalid.
  StepReport step(const SystemState& start, double h, SystemState& next);

  /// Returns the estimated error of the last step, see StepError [m].
  double local_error(const SystemState& start, const SystemState& next) { return error_(*assembly_, start, next, dq_); }

  /// Drops all caches, so that a restart reproduces the run: for checkpoints.
  void forget() {
    factored_ = false;
    assembly_->forget_contacts();
  }

 private:
  StepReport step_with_drives(const SystemState& start, double h, SystemState& next);
  bool update_drives(const SystemState& next);
  void correct(SystemState& next, double h) const;
  bool must_factor(double h) const;
  bool make_factors(double h, StepReport& report);
  bool can_reuse_factors(const StepReport& report, const SystemState& start, SystemState& next, const Weights& weights);
  bool converges_slowly(std::size_t part, double max_further_iterations) const;
  bool find_slow_lines(bool contacts_renewed);

  Assembly* assembly_;
  StepSettings settings_;
  GeneralizedAlpha scheme_;
  EndPayoutSolver end_payouts_;
  std::vector<MachineStep> moves_;  ///< Per tensioner of the system.
  bool factored_ = false;
  std::vector<char> factored_governed_;  ///< Per tensioner: true if factored with the end free along its guide.
  double factored_step_ = 0.0;
  std::uint64_t factored_contacts_ = 0;
  int factors_age_ = 0;
  std::vector<double>
      max_further_iterations_;    ///< Per line: number of iterations that cost less than new factors within a step,
  std::vector<char> slow_lines_;  ///< and whether the line needs new factors.
  std::vector<double> before_;    ///< Assembly::residuals() before the last correction.
  Increments dq_;
  StepError error_;
};

}  // namespace overbend
