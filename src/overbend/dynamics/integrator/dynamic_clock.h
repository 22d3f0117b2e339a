/// The clock that the steps of a run must meet, and the choice of steps between its ticks.
#pragma once

#include <cstdint>
#include <vector>

#include "dynamics/integrator/dynamics.h"

namespace overbend {

/// Counts the clock's ticks, so that times are products and not sums.
struct Clock {
  double interval = 0.5;
  std::int64_t tick = 0, ticks_per_row = 1, last_tick = 0;

  double time() const { return static_cast<double>(tick) * interval; }
  bool at_row() const { return tick % ticks_per_row == 0; }
  /// Tick of the row after this one.
  std::int64_t next_row() const {
    return tick - ((tick % ticks_per_row) + ticks_per_row) % ticks_per_row + ticks_per_row;
  }
};

/// When a run ends: at the first row at or after its duration [s].
double end_of_run(double duration, double output_step);

Clock make_clock(const DynamicOptions& options, double interval);

/// Shortest steps that a tension asks for [s]: as a rule, and where it bends by ten times more than those leave to be
/// followed, as when a slack line snaps tight.
struct ShortestSteps {
  double usual = 0.0, snap = 0.0;
};

/// Watches how the tension at the top bends from step to step. Steps that follow its swings to a fraction of their
/// period follow everything else that swings with them.
struct TensionWatch {
  double last = 0.0, slope = 0.0;       ///< After the last step [N], over it [N/s].
  double least = 1e300, most = -1e300;  ///< So far [N].

  void start(double tension);
  /// Longest step that the tension after one of `h` allows [s].
  double longest_step(double tension, double h, const ShortestSteps& shortest) const;
  void took(double tension, double h);
};

inline constexpr double kSmallestStep = 1e-7;  ///< [s]
/// Shares of DynamicOptions::time_scale. The first step, and the shortest that the tension of a pipe asks for: what
/// impacts put on it is not followed further. 20 ms as a rule.
inline constexpr double kShortStep = 0.16;
/// The first step after something parted, and the shortest to the instant of a change or by the tension of lines: a
/// jerk goes through a wire with the speed of sound, some metres in it. 1 ms as a rule.
inline constexpr double kEventStep = 0.008;

/// Chooses steps between ticks.
struct StepChooser {
  double wanted = 0.02;                          ///< By error and impacts [s].
  double last = 0.0;                             ///< Step chosen last [s].
  double taken = 0.0;                            ///< Step taken last: a chosen one may have been cut [s].
  int times = 0;                                 ///< Steps of that length, one after the other.
  double estimated = 0.0, estimated_step = 0.0;  ///< Error estimated last [m], and the step it is of [s].
  int unseen = 0;                                ///< Steps since.

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
  /// After a step of `h`.
  void took(double h);
  /// At an instant from which on what is to come does not follow from what was: errors estimated before say nothing.
  /// The next is of `h` at most.
  void start_short(double h);
  /// Error of the step taken, from `estimate()`; where that of a few steps before leads to next to nothing, and
  /// `longest` is far longer than they were, as with the short steps of impacts, by the cube of the step.
  template <class Estimate>
  double error(double tolerance, double longest, Estimate estimate) {
    const double expected = expected_error();
    if (may_go_unseen(expected, tolerance, longest)) {
      ++unseen;
      return expected;
    }
    estimated = estimate();
    estimated_step = taken;
    unseen = 0;
    return estimated;
  }
  /// Wants the step after the one taken, which made an error of `error`, for an error of `tolerance`; `longest` at most
  /// [s].
  void adapt(double error, double tolerance, double longest);
  /// A step that leads to the next tick in equal parts; that of before where it does so too, so that factors serve on.
  double choose(double remaining, double longest);

 private:
  double expected_error() const;
  bool may_go_unseen(double expected, double tolerance, double longest) const;
};

}  // namespace overbend
