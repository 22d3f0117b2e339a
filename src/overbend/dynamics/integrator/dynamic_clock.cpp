#include "dynamics/integrator/dynamic_clock.h"

#include <algorithm>
#include <cmath>

namespace overbend {
namespace {

/// Of a swing of frequency w, h^2 T'' is (w h)^2/2 of its range: w h = 0.1, 63 steps a period, leaves 0.2 % of the
/// range as error of the scheme.
constexpr double kBendOfRange = 5e-3;
constexpr double kBendOfTension = 1e-4;  ///< Where hardly anything swings.
constexpr double kSnap = 0.3;            ///< Of the shortest usual step: a tenth of its bend.
constexpr double kLeastGrowth = 1.15;    ///< Of the step: less is not worth new factors.
constexpr double kMostGrowth = 2.25;     ///< Of the step, where it may grow at all.
constexpr int kTimesToGrow = 2;          ///< Steps of one length before a longer one: factors serve both.
constexpr double kNextToNothing = 0.01;  ///< Of the tolerance: steps that grow by kMostGrowth leave it far away.
constexpr int kMostUnseen = 4;           ///< Steps in succession without an estimate of their error,
constexpr double kUnseenTime = 0.1;      ///< and how long they may be together, of the longest step.

/// Steps of output that cover a time: a time just over a whole number of them is that number.
std::int64_t rows_in(double time, double output_step) {
  return static_cast<std::int64_t>(std::ceil(time / output_step - 1e-9));
}

}  // namespace

double end_of_run(double duration, double output_step) {
  return static_cast<double>(rows_in(duration, output_step)) * output_step;
}

Clock make_clock(const DynamicOptions& options, double interval) {
  Clock clock;
  clock.interval = interval;
  clock.ticks_per_row = std::llround(options.output_step / interval);
  clock.tick = -rows_in(options.build_up, options.output_step) * clock.ticks_per_row;
  clock.last_tick = rows_in(options.duration, options.output_step) * clock.ticks_per_row;
  return clock;
}

void TensionWatch::start(double tension) {
  *this = {tension, 0.0, tension, tension};
}

double TensionWatch::longest_step(double tension, double h, const ShortestSteps& shortest) const {
  const double bend = std::abs((tension - last) / h - slope) * h;  // h^2 T''
  const double range = std::max(most, tension) - std::min(least, tension);
  const double allowed = std::max(kBendOfRange * range, kBendOfTension * std::abs(tension));
  const double step = h * std::sqrt(allowed / std::max(bend, 1e-9 * allowed));
  return std::max(step, step < kSnap * shortest.usual ? shortest.snap : shortest.usual);
}

void TensionWatch::took(double tension, double h) {
  slope = (tension - last) / h;
  last = tension;
  least = std::min(least, tension);
  most = std::max(most, tension);
}

void StepChooser::took(double h) {
  times = h == taken ? times + 1 : 1;
  taken = h;
}

void StepChooser::start_short(double h) {
  wanted = std::min(wanted, h);
  estimated_step = 0.0;
  unseen = 0;
}

double StepChooser::expected_error() const {
  const double ratio = estimated_step > 0.0 ? taken / estimated_step : 0.0;
  return estimated * ratio * ratio * ratio;
}

bool StepChooser::may_go_unseen(double expected, double tolerance, double longest) const {
  return estimated_step > 0.0 && unseen < kMostUnseen && (unseen + 1) * taken < kUnseenTime * longest &&
         expected < kNextToNothing * tolerance;
}

void StepChooser::adapt(double error, double tolerance, double longest) {
  const double most = times < kTimesToGrow ? 1.0 : kMostGrowth;
  const double growth = std::clamp(0.9 * std::cbrt(tolerance / std::max(error, 1e-12)), 0.3, most);
  wanted = std::clamp(taken * growth, kSmallestStep, longest);
}

double StepChooser::choose(double remaining, double longest) {
  const double limit = std::min(wanted, longest);
  const double parts = remaining / last;
  const bool fits = last > 0.0 && std::abs(parts - std::round(parts)) < 1e-6 && parts > 0.5;
  if (!(fits && last <= limit * (1.0 + 1e-9) && last * kLeastGrowth > std::min(limit, remaining))) {
    last = remaining / std::ceil(remaining / limit - 1e-9);
  }
  return last;
}

}  // namespace overbend
