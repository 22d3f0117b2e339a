#include "numerics/record_part.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <vector>

#include "numerics/extremes.h"

namespace overbend {
namespace {

constexpr std::size_t kMinValues = 20;  ///< Minimum number of values for an autocorrelation.
constexpr std::size_t kShortLags = 10;  ///< Maximum lag as a fraction of the record: one part in this many.

double mean_value(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double deviation_from_mean(std::span<const double> values, double mean) {
  double squares = 0.0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return std::sqrt(squares / static_cast<double>(values.size()));
}

/// Returns the mean of the highest third.
double significant_height(std::vector<double> peaks, double mean) {
  const std::size_t third = std::max<std::size_t>(1, peaks.size() / 3);
  std::nth_element(peaks.begin(), peaks.begin() + static_cast<std::ptrdiff_t>(third) - 1, peaks.end(),
                   std::greater<>());
  return mean_value(std::span(peaks).first(third)) - mean;
}

/// Most probable maximum of a narrow-banded Gaussian process.
double rayleigh_maximum(double deviation, double cycles) {
  return cycles > 1.0 ? deviation * std::sqrt(2.0 * std::log(cycles)) : 0.0;
}

}  // namespace

PartHeights compute_heights(std::span<const double> values, double step, double reference_time) {
  PartHeights heights;
  if (values.size() < 2) return heights;
  const RecordPeaks record = peaks_between_up_crossings(values);
  const double highest = *std::max_element(values.begin(), values.end()) - record.mean;
  heights.cycles = static_cast<double>(record.peaks.size());
  heights.maximum = heights.significant = highest;
  if (record.peaks.empty() || record.steps <= 0.0) return heights;
  heights.significant = significant_height(record.peaks, record.mean);
  const double expected = heights.cycles * reference_time / (record.steps * step);
  const ExtremeFit fit = fit_peaks(record.peaks, record.mean, std::max(expected, 2.0));
  heights.maximum = fit.method != ExtremeMethod::none
                        ? fit.estimate.value - record.mean
                        : std::max(highest, rayleigh_maximum(deviation_from_mean(values, record.mean), expected));
  return heights;
}

double combined_height(const PartHeights& slow, const PartHeights& wave) {
  return std::max(slow.maximum + wave.significant, slow.significant + wave.maximum);
}

double deviation_error(std::span<const double> values, double step, double resolution) {
  const auto stride = static_cast<std::size_t>(std::max(1.0, std::floor(resolution / step)));
  std::vector<double> thin;
  for (std::size_t i = 0; i < values.size(); i += stride) thin.push_back(values[i]);
  if (thin.size() < kMinValues) return 0.0;
  const double mean = mean_value(thin);
  for (double& value : thin) value -= mean;
  const double variance = std::inner_product(thin.begin(), thin.end(), thin.begin(), 0.0);
  if (!(variance > 0.0)) return 0.0;
  double squares = 1.0;
  for (std::size_t lag = 1; lag <= thin.size() / kShortLags; ++lag) {
    const double rho =
        std::inner_product(thin.begin() + static_cast<std::ptrdiff_t>(lag), thin.end(), thin.begin(), 0.0) / variance;
    squares += 2.0 * rho * rho;
  }
  return 0.5 * std::sqrt(2.0 * squares / static_cast<double>(thin.size()));
}

}  // namespace overbend
