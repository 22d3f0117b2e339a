/// One step of a system in time: generalized-alpha with Newton's method.
#pragma once

#include "dynamics/giving_ends.h"
#include "system/assembly.h"

namespace overbend {

struct StepSettings {
  double spectral_radius = 0.6;
  double tolerance = 1e-6;  ///< Largest unbalanced nodal force over the force scale.
  int max_iterations = 12;
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

  /// Estimate of the error that the last step made in the place of any node or body (turned on its arm) [m]: the change
  /// of acceleration over the step times h^2 |1/6 - beta|, filtered by the factored system so that vibrations far
  /// faster than the step, which the scheme damps, do not count (after Shampine 1984). Beside elements longer than 5 m
  /// errors of moorings and of laid pipe that was added behind the static line count less in proportion.
  double local_error(const SystemState& now, const SystemState& next);

  /// What comes next depends on the state alone: for checkpoints.
  void forget() {
    factored_ = false;
    assembly_->forget_contacts();
  }

 private:
  void predict(const SystemState& now, double h, TensionerDrive drive, const SpeedBounds& bounds,
               SystemState& next) const;
  void end_accelerations(const SystemState& now, double ratio, SystemState& next) const;
  void predict_travel(const AttachmentState& now, double h, double ratio, const SpeedBounds& bounds,
                      AttachmentState& next) const;
  StepReport step_with(TensionerDrive drive, const SpeedBounds& bounds, const SystemState& now, double h,
                       SystemState& next);
  void correct(SystemState& next, double h) const;
  double body_error() const;
  bool must_factor(double h) const;
  bool factors_serve(const StepReport& report, double residual_before, const SystemState& next, const Weights& weights);

  Assembly* assembly_;
  StepSettings settings_;
  GeneralizedAlpha scheme_;
  GivingEnds giving_;
  bool factored_ = false;
  bool factored_governed_ = false;  ///< With the top free along its guide.
  double factored_step_ = 0.0;
  std::uint64_t factored_contacts_ = 0;
  int factors_age_ = 0;
  Increments dq_;
  std::vector<std::vector<double>> lumped_mass_;    ///< Line by line.
  std::vector<std::vector<double>> error_weights_;  ///< Line by line, of its nodes.
};

}  // namespace overbend
