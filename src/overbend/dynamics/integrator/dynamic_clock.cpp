#include "dynamics/integrator/dynamic_clock.h"

#include <algorithm>
#include <cmath>

namespace overbend {
namespace {

/// Allowed h^2 T'' as a share of the tension range. A harmonic variation of frequency w has h^2 T'' = (w h)^2/2 of its
/// range: w h = 0.1, 63 steps per period, leaves an error of the scheme of 0.2 % of the range.
constexpr double kSecondDifferenceOfRange = 5e-3;
/// Minimum allowed h^2 T'' as a share of the tension, for small tension ranges.
constexpr double kSecondDifferenceOfTension = 1e-4;
constexpr double kSnapStepFactor = 0.3;    ///< Factor on the minimum usual step; its h^2 T'' is a tenth.
constexpr double kMinGrowth = 1.15;        ///< Minimum growth factor of a step: less is not worth new factors.
constexpr double kMaxGrowth = 2.25;        ///< Maximum growth factor of a step.
constexpr int kStepsBeforeGrowth = 2;      ///< Steps of the same length before a longer one: factors serve both.
constexpr double kNegligibleError = 0.01;  ///< Share of the tolerance: steps that grow by kMaxGrowth stay far below it.
constexpr int kMaxUnestimatedSteps = 4;    ///< Maximum number of successive steps without an error estimate,
constexpr double kMaxUnestimatedTime = 0.1;  ///< and their maximum total duration as a share of the maximum step.

/// Number of output steps that cover a time. A time longer than a whole number of them by rounding counts as that
/// number.
std::int64_t count_output_steps(double time, double output_step) {
  return static_cast<std::int64_t>(std::ceil(time / output_step - 1e-9));
}

}  // namespace

double end_of_run(double duration, double output_step) {
  return static_cast<double>(count_output_steps(duration, output_step)) * output_step;
}

Clock make_clock(const DynamicOptions& options, double interval) {
  Clock clock;
  clock.interval = interval;
  clock.ticks_per_row = std::llround(options.output_step / interval);
  clock.tick = -count_output_steps(options.build_up, options.output_step) * clock.ticks_per_row;
  clock.last_tick = count_output_steps(options.duration, options.output_step) * clock.ticks_per_row;
  return clock;
}

void TensionMonitor::start(double tension) {
  *this = {tension, 0.0, tension, tension};
}

double TensionMonitor::max_allowed_step(double tension, double h, const MinSteps& min_steps) const {
  const double bend = std::abs((tension - last) / h - slope) * h;  // h^2 T''
  const double range = std::max(max_tension, tension) - std::min(min_tension, tension);
  const double allowed = std::max(kSecondDifferenceOfRange * range, kSecondDifferenceOfTension * std::abs(tension));
  const double step = h * std::sqrt(allowed / std::max(bend, 1e-9 * allowed));
  return std::max(step, step < kSnapStepFactor * min_steps.usual ? min_steps.snap : min_steps.usual);
}

void TensionMonitor::took(double tension, double h) {
  slope = (tension - last) / h;
  last = tension;
  min_tension = std::min(min_tension, tension);
  max_tension = std::max(max_tension, tension);
}

void StepSizeController::took(double h) {
  times = h == taken ? times + 1 : 1;
  taken = h;
}

void StepSizeController::restart_with_step(double h) {
  wanted = std::min(wanted, h);
  estimated_step = 0.0;
  unseen = 0;
}

double StepSizeController::expected_error() const {
  const double ratio = estimated_step > 0.0 ? taken / estimated_step : 0.0;
  return estimated * ratio * ratio * ratio;
}

bool StepSizeController::may_skip_estimate(double expected, double tolerance, double max_step) const {
  return estimated_step > 0.0 && unseen < kMaxUnestimatedSteps &&
         (unseen + 1) * taken < kMaxUnestimatedTime * max_step && expected < kNegligibleError * tolerance;
}

void StepSizeController::adapt(double error, double tolerance, double max_step) {
  const double max_growth = times < kStepsBeforeGrowth ? 1.0 : kMaxGrowth;
  const double growth = std::clamp(0.9 * std::cbrt(tolerance / std::max(error, 1e-12)), 0.3, max_growth);
  wanted = std::clamp(taken * growth, kMinTimeStep, max_step);
}

double StepSizeController::choose(double remaining, double max_step) {
  const double limit = std::min(wanted, max_step);
  const double parts = remaining / last;
  const bool fits = last > 0.0 && std::abs(parts - std::round(parts)) < 1e-6 && parts > 0.5;
  if (!(fits && last <= limit * (1.0 + 1e-9) && last * kMinGrowth > std::min(limit, remaining))) {
    last = remaining / std::ceil(remaining / limit - 1e-9);
  }
  return last;
}

}  // namespace overbend
