/// Clock that the steps of a run must meet, and step size control between its ticks.
#pragma once

#include <cstdint>
#include <vector>

#include "dynamics/integrator/dynamics.h"

namespace overbend {

/// Counts clock ticks, so that times are products and not sums.
struct Clock {
  double interval = 0.5;
  std::int64_t tick = 0, ticks_per_row = 1, last_tick = 0;

  double time() const { return static_cast<double>(tick) * interval; }
  bool at_row() const { return tick % ticks_per_row == 0; }
  /// Tick of the next output step.
  std::int64_t next_row() const {
    return tick - ((tick % ticks_per_row) + ticks_per_row) % ticks_per_row + ticks_per_row;
  }
};

/// Returns the end of a run [s]: the first output step at or after its duration.
double end_of_run(double duration, double output_step);

/// Returns the clock of a run with ticks every `interval` [s].
Clock make_clock(const DynamicOptions& options, double interval);

/// Minimum steps required by a tension [s]: the usual one, and the one for a second difference ten times larger than
/// the usual step can follow, as when a slack line snaps tight.
struct MinSteps {
  double usual = 0.0, snap = 0.0;
};

/// Monitors the second difference of a tension from step to step. Steps that resolve its oscillations to a fraction of
/// their period resolve everything else that oscillates with them.
struct TensionMonitor {
  double last = 0.0, slope = 0.0;                    ///< After the last step [N]; its rate over that step [N/s].
  double min_tension = 1e300, max_tension = -1e300;  ///< Extremes so far [N].

  void start(double tension);
  /// Returns the maximum step [s] allowed by the tension after a step of `h`.
  double max_allowed_step(double tension, double h, const MinSteps& min_steps) const;
  /// Records the tension after an accepted step of `h`.
  void took(double tension, double h);
};

inline constexpr double kMinTimeStep = 1e-7;  ///< Minimum step [s].
/// First step, and minimum step required by the tension of a pipe, as a share of DynamicOptions::time_scale. Tension
/// changes caused by impacts are not resolved further. Usually 20 ms.
inline constexpr double kShortStep = 0.16;
/// First step after a line failure, and minimum step to an event or required by the tension of lines, as a share of
/// DynamicOptions::time_scale. A jerk travels along a wire at the speed of sound, some metres within this step. Usually
/// 1 ms.
inline constexpr double kEventStep = 0.008;

/// Step size control between ticks.
struct StepSizeController {
  double wanted = 0.02;                          ///< Step required by error and impacts [s].
  double last = 0.0;                             ///< Last chosen step [s].
  double taken = 0.0;                            ///< Last step taken [s]; a chosen step may have been cut.
  int times = 0;                                 ///< Number of successive steps of that length.
  double estimated = 0.0, estimated_step = 0.0;  ///< Last error estimate [m], and the step it belongs to [s].
  int unseen = 0;                                ///< Number of steps since.

  std::vector<double> save() const {
    return {wanted, last, taken, static_cast<double>(times), estimated, estimated_step, static_cast<double>(unseen)};
  }
  void restore(const std::vector<double>& saved) {
    *this = {saved.at(0),
             saved.at(1),
             saved.at(2),
             static_cast<int>(saved.at(3)),
             saved.at(4),
             saved.at(5),
             static_cast<int>(saved.at(6))};
  }
  /// Records a step of `h`.
  void took(double h);
  /// After a discontinuity: discards earlier error estimates. The next step is at most `h`.
  void restart_with_step(double h);
  /// Returns the error of the step taken, from `estimate()`. If the estimate of a few steps before extrapolates, with
  /// the cube of the step, to a negligible error, and `max_step` is far longer than these steps (as with the short
  /// steps of impacts), the extrapolated error is returned instead.
  template <class Estimate>
  double error(double tolerance, double max_step, Estimate estimate) {
    const double expected = expected_error();
    if (may_skip_estimate(expected, tolerance, max_step)) {
      ++unseen;
      return expected;
    }
    estimated = estimate();
    estimated_step = taken;
    unseen = 0;
    return estimated;
  }
  /// Sets the next step from the `error` of the last one for an error of `tolerance`; at most `max_step` [s].
  void adapt(double error, double tolerance, double max_step);
  /// Returns a step that divides the time to the next tick into equal parts; the previous step if it does so, too, so
  /// that the factors can be reused.
  double choose(double remaining, double max_step);

 private:
  double expected_error() const;
  bool may_skip_estimate(double expected, double tolerance, double max_step) const;
};

}  // namespace overbend
