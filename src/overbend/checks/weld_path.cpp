#include "checks/weld_path.h"

#include <algorithm>
#include <cmath>

namespace overbend {
namespace {

/// Returns the sum of the rates at stops `pace.joint` apart, the first `phase` from the top [1/s].
double rates_at_stops(std::span<const double> s, std::span<const double> rate, double joint, double phase) {
  double sum = 0.0;
  std::size_t right = s.size() - 1;
  for (double weld = s.back() - phase; weld >= s.front() && right > 0; weld -= joint) {
    while (right > 1 && s[right - 1] > weld) --right;
    const double fraction = std::clamp((weld - s[right - 1]) / (s[right] - s[right - 1]), 0.0, 1.0);
    sum += rate[right - 1] + fraction * (rate[right] - rate[right - 1]);
  }
  return sum;
}

/// Returns the maximum sum over the stops: it is piecewise linear in their phase, so that its maximum is at a station.
double worst_stops(std::span<const double> s, std::span<const double> rate, double joint) {
  double worst = 0.0;
  for (const double station : s) {
    worst = std::max(worst, rates_at_stops(s, rate, joint, std::fmod(s.back() - station, joint)));
  }
  return worst;
}

}  // namespace

WeldPath weld_path(std::span<const double> s, std::span<const double> rate, const LayPace& pace) {
  WeldPath path;
  path.accumulated.assign(s.size(), 0.0);
  double integral = 0.0;
  for (std::size_t i = s.size(); i-- > 1;) {
    integral += 0.5 * (rate[i] + rate[i - 1]) * (s[i] - s[i - 1]);
    path.accumulated[i - 1] = integral / pace.speed();
  }
  path.mean = integral / pace.speed();
  const double moving = integral / pace.joint * pace.move_time;
  path.worst = std::max(path.mean, moving + pace.weld_time * worst_stops(s, rate, pace.joint));
  return path;
}

}  // namespace overbend
