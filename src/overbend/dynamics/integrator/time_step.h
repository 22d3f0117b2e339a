/// One step of a system in time: generalized-alpha with Newton's method.
#pragma once

#include "dynamics/integrator/step_error.h"
#include "dynamics/integrator/step_prediction.h"
#include "dynamics/machines/giving_ends.h"
#include "system/assembly.h"

namespace overbend {

struct StepSettings {
  double spectral_radius = 0.6;
  double tolerance = 1e-6;  ///< Largest unbalanced nodal force over the force scale.
  int max_iterations = 12;
  double short_element = 5.0;  ///< Beside longer ones errors of moorings count less, see StepError [m].
};

enum class StepEnd { converged, too_many_iterations, singular, lost };

struct StepReport {
  StepEnd end = StepEnd::too_many_iterations;
  int iterations = 0;
  int factorisations = 0;
  double residual = 0.0;
  std::pair<int, int> worst_place{0, 0};  ///< Line and node.
  bool converged() const { return end == StepEnd::converged; }
};

/// Takes steps; holds factors of the last tangent, which serve as long as step size, contacts and convergence allow.
class TimeStepper {
 public:
  TimeStepper(Assembly& assembly, const StepSettings& settings);

  /// From `now` over `h` to `next`; the system is left evaluated at `next`. On failure `next` is of no use.
  StepReport step(const SystemState& now, double h, SystemState& next);

  /// Estimate of the error that the last step made, see StepError [m].
  double local_error(const SystemState& now, const SystemState& next) { return error_(*assembly_, now, next, dq_); }

  /// What comes next depends on the state alone: for checkpoints.
  void forget() {
    factored_ = false;
    assembly_->forget_contacts();
  }

 private:
  StepReport step_with_drives(const SystemState& now, double h, SystemState& next);
  bool fit_drives(const SystemState& next);
  void correct(SystemState& next, double h) const;
  bool must_factor(double h) const;
  bool make_factors(double h, StepReport& report);
  bool factors_serve(const StepReport& report, const SystemState& now, SystemState& next, const Weights& weights);
  bool slow(std::size_t part, double most_further) const;
  bool find_slow_lines(bool contacts_renewed);

  Assembly* assembly_;
  StepSettings settings_;
  GeneralizedAlpha scheme_;
  GivingEnds giving_;
  std::vector<MachineStep> moves_;  ///< Of the tensioners of the system.
  bool factored_ = false;
  std::vector<char> factored_governed_;  ///< By tensioners: with an end free along its guide.
  double factored_step_ = 0.0;
  std::uint64_t factored_contacts_ = 0;
  int factors_age_ = 0;
  std::vector<double> most_further_;  ///< By lines: iterations that cost less than new factors within a step,
  std::vector<char> slow_lines_;      ///< and whether these are needed.
  std::vector<double> before_;        ///< Assembly::residuals() before the last correction.
  Increments dq_;
  StepError error_;
};

}  // namespace overbend
