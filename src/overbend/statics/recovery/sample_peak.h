/// Maximum of samples along the line, interpolated between them.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/ranges.h"

namespace overbend {

struct Sample {
  double x = 0.0, value = 0.0;
};

/// Returns the maximum of samples in the order of x, by the parabola through it and its neighbours. A very close
/// neighbour indicates a kink, where no parabola applies. All zero without samples.
inline Sample peak(const std::vector<Sample>& samples) {
  if (samples.empty()) return {};
  const auto maximum = ranges::max_element(samples, {}, &Sample::value);
  if (maximum == samples.begin() || maximum + 1 == samples.end()) return *maximum;
  constexpr double kKink = 2e-3;  // [m]
  const Sample &a = *(maximum - 1), &b = *maximum, &c = *(maximum + 1);
  if (std::min(std::abs(b.x - a.x), std::abs(c.x - b.x)) < kKink) return b;
  const double before = (b.value - a.value) / (b.x - a.x), behind = (c.value - b.value) / (c.x - b.x);
  const double bend = (behind - before) / (c.x - a.x);
  if (!(bend < 0.0)) return b;
  const double slope = before + bend * (b.x - a.x);  // slope of the parabola at b
  const double x = std::clamp(b.x - 0.5 * slope / bend, std::min(a.x, c.x), std::max(a.x, c.x));
  return {x, b.value + (slope + bend * (x - b.x)) * (x - b.x)};
}

}  // namespace overbend
