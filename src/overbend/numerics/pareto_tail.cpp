#include "numerics/pareto_tail.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

#include "base/ranges.h"
#include "numerics/random_draw.h"
#include "numerics/tail_check.h"

namespace overbend {
namespace {

constexpr std::size_t kMinPeaksOver = 12;   ///< Minimum number of peaks over a threshold to estimate a shape.
constexpr double kRise = 1.4;               ///< Ratio of the numbers of peaks over successive thresholds.
constexpr double kMaxShape = 0.5;           ///< Maximum magnitude of the shape: beyond it, moments do not determine it.
constexpr double kMaxDistance = 0.40;       ///< Exceeded by 5 % of samples, from 12 to 200 values, shapes 0 to 0.4.
constexpr double kMinProbability = 0.02;    ///< Minimum probability of the largest values.
constexpr std::size_t kMaxTestedPeaks = 5;  ///< Number of largest values tested.
constexpr int kSamples = 400;               ///< Number of samples for an interval.
constexpr double kAlmostExponential = 1e-9;  ///< Shape treated as exponential below this.

/// Returns the fraction of a distribution with this shape and scale 1 above y.
double share_above(double y, double shape) {
  if (std::abs(shape) < kAlmostExponential) return std::exp(-y);
  const double base = 1.0 + shape * y;
  return base > 0.0 ? std::pow(base, -1.0 / shape) : 0.0;
}

/// Returns the y with that fraction above it.
double with_share(double share, double shape) {
  if (std::abs(shape) < kAlmostExponential) return -std::log(share);
  return (std::pow(share, -shape) - 1.0) / shape;
}

struct ScaleShape {
  double scale = 0.0, shape = 0.0;
};

/// Fit to values in ascending order. A distribution with an upper end ends beyond the largest value.
ScaleShape by_moments(std::span<const double> y) {
  const double n = static_cast<double>(y.size());
  double mean = 0.0, weighted = 0.0;
  for (std::size_t i = 0; i < y.size(); ++i) {
    mean += y[i] / n;
    weighted += (1.0 - (static_cast<double>(i) + 0.65) / n) * y[i] / n;
  }
  double shape = std::clamp(2.0 - mean / (mean - 2.0 * weighted), -kMaxShape, kMaxShape);
  if (shape < 0.0 && mean * (1.0 - shape) / -shape <= y.back()) {
    const double end = y.back() * (1.0 + 1.0 / n);
    shape = -mean / (end - mean);
  }
  return {mean * (1.0 - shape), shape};
}

/// Returns the maximum excess of each run of peaks above the threshold, ascending.
std::vector<double> clusters_over(std::span<const double> peaks, double threshold) {
  std::vector<double> over;
  bool inside = false;
  for (const double peak : peaks) {
    const double y = peak - threshold;
    if (y > 0.0) {
      if (!inside) over.push_back(y);
      over.back() = std::max(over.back(), y);
    }
    inside = y > 0.0;
  }
  ranges::sort(over);
  return over;
}

bool describes(const ScaleShape& fit, std::span<const double> y) {
  std::vector<double> shares, expected;
  for (const double value : y) shares.push_back(1.0 - share_above(value / fit.scale, fit.shape));
  const double n = static_cast<double>(y.size());
  for (std::size_t i = 0; i < std::min(kMaxTestedPeaks, y.size()); ++i) {
    expected.push_back(n * (1.0 - shares[y.size() - 1 - i]));
  }
  return upper_tail_distance(shares) < kMaxDistance && min_probability(expected) > kMinProbability;
}

ParetoTail tail_over(std::span<const double> peaks, double threshold) {
  const std::vector<double> over = clusters_over(peaks, threshold);
  const ScaleShape fit = by_moments(over);
  return {threshold,
          fit.scale,
          fit.shape,
          over.size(),
          static_cast<double>(over.size()) / static_cast<double>(peaks.size()),
          describes(fit, over)};
}

/// Returns the number of events of a Poisson process with the expected number `mean`, from random waiting times.
int drawn_count(double mean, std::mt19937_64& generator) {
  int count = -1;
  for (double time = 0.0; time <= mean; ++count) time -= std::log(uniform_draw(generator));
  return count;
}

}  // namespace

double ParetoTail::above(double value) const {
  return value <= threshold ? 1.0 : share_above((value - threshold) / scale, shape);
}

double ParetoTail::once_in(double expected_peaks) const {
  const double expected = expected_peaks * per_peak;
  return expected > 1.0 ? threshold + scale * with_share(1.0 / expected, shape) : threshold;
}

std::optional<ParetoTail> fit_pareto_tail(std::span<const double> peaks, std::size_t max_count) {
  std::vector<double> sorted(peaks.begin(), peaks.end());
  ranges::sort(sorted, std::greater<>());
  std::optional<ParetoTail> found;
  max_count = std::min(max_count, sorted.size() / 2);
  double over = static_cast<double>(max_count);
  while (over >= static_cast<double>(kMinPeaksOver)) {
    const auto k = static_cast<std::size_t>(over);
    over /= kRise;
    const double threshold = 0.5 * (sorted[k - 1] + sorted[k]);
    if (!(sorted.front() > threshold) || !(sorted[k - 1] > threshold)) continue;
    found = tail_over(peaks, threshold);
    if (found->described) break;
  }
  return found;
}

ConfidentEstimate confident(const ParetoTail& tail, double expected_peaks) {
  std::mt19937_64 generator(20240001);
  const double peaks = static_cast<double>(tail.clusters) / tail.per_peak;
  std::vector<double> estimates, y;
  for (int i = 0; i < kSamples; ++i) {
    y.resize(static_cast<std::size_t>(std::max(2, drawn_count(static_cast<double>(tail.clusters), generator))));
    for (double& value : y) value = tail.scale * with_share(uniform_draw(generator), tail.shape);
    ranges::sort(y);
    const ScaleShape fit = by_moments(y);
    const ParetoTail drawn{tail.threshold, fit.scale, fit.shape, y.size(), static_cast<double>(y.size()) / peaks, true};
    estimates.push_back(drawn.once_in(expected_peaks));
  }
  ranges::sort(estimates);
  constexpr std::size_t kCut = kSamples / 40;  // 2.5 % at each end
  return {tail.once_in(expected_peaks), estimates[kCut], estimates[kSamples - 1 - kCut]};
}

}  // namespace overbend
