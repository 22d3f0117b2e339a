#include "numerics/extremes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace overbend {
namespace {

constexpr std::size_t kFewestBlocks = 10;

void fit_weibull(ExtremeFit& fit, std::span<const double> peaks, double mean, double expected_peaks) {
  std::vector<double> tail(peaks.begin(), peaks.end());
  std::sort(tail.begin(), tail.end());
  const std::size_t below = tail.size() / 2;
  tail.erase(tail.begin(), tail.begin() + static_cast<std::ptrdiff_t>(below));
  for (double& value : tail) {
    value = std::log(std::max(value - mean, 0.0));
  }
  const auto log_weibull = std::isfinite(tail.front()) ? fit_log_weibull(tail, below) : std::nullopt;
  if (!log_weibull) {
    fit.weibull = {fit.observed, fit.observed, fit.observed};
    return;
  }
  fit.weibull_scale = std::exp(log_weibull->location);
  fit.weibull_shape = 1.0 / log_weibull->scale;
  // 1 - F(x) = 1/n
  const ConfidentEstimate log = confident(*log_weibull, tail.size(), below, std::log(std::log(expected_peaks)));
  fit.weibull = {mean + std::exp(log.value), mean + std::exp(log.low), mean + std::exp(log.high)};
}

void fit_gumbel(ExtremeFit& fit, std::span<const double> peaks, double expected_peaks) {
  const double root = std::sqrt(static_cast<double>(peaks.size()));
  const std::size_t blocks = std::max(kFewestBlocks, static_cast<std::size_t>(std::lround(root)));
  const std::size_t each = peaks.size() / blocks;
  fit.peaks_per_block = static_cast<int>(each);
  std::vector<double> turned;  // a Gumbel variable with its sign turned is distributed as the log of a Weibull variable
  for (std::size_t b = 0; b < blocks; ++b) {
    const std::span<const double> block = peaks.subspan(b * each, each);
    turned.push_back(-*std::max_element(block.begin(), block.end()));
  }
  std::sort(turned.begin(), turned.end());
  const auto gumbel = fit_log_weibull(turned, 0);
  if (!gumbel) {
    fit.gumbel = {fit.observed, fit.observed, fit.observed};
    return;
  }
  fit.gumbel_mode = -gumbel->location;
  fit.gumbel_scale = gumbel->scale;
  // The largest of r blocks has its mode at mode + scale ln r.
  const double ratio = expected_peaks / static_cast<double>(each);
  const ConfidentEstimate least = confident(*gumbel, turned.size(), 0, -std::log(ratio));
  fit.gumbel = {-least.value, -least.high, -least.low};
}

}  // namespace

RecordPeaks peaks_between_up_crossings(std::span<const double> values) {
  RecordPeaks record;
  if (values.empty()) {
    return record;
  }
  record.mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  std::size_t first = 0;  // no crossing is at the first value
  std::size_t last = 0;
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (values[i - 1] < record.mean && values[i] >= record.mean) {
      if (first == 0) {
        first = i;
      } else {
        record.peaks.push_back(*std::max_element(values.begin() + static_cast<std::ptrdiff_t>(last),
                                                 values.begin() + static_cast<std::ptrdiff_t>(i)));
      }
      last = i;
    }
  }
  record.steps = static_cast<double>(last - first);
  return record;
}

ExtremeFit fit_peaks(std::span<const double> peaks, double mean, double expected_peaks) {
  ExtremeFit fit;
  fit.peaks = static_cast<int>(peaks.size());
  fit.observed = peaks.empty() ? mean : *std::max_element(peaks.begin(), peaks.end());
  fit.weibull = fit.gumbel = {fit.observed, fit.observed, fit.observed};
  fit.enough = fit.peaks >= kFewestPeaks && expected_peaks > 1.0;
  if (fit.enough) {
    fit_weibull(fit, peaks, mean, expected_peaks);
    fit_gumbel(fit, peaks, expected_peaks);
  }
  return fit;
}

ExtremeFit fit_extremes(std::span<const double> values, double step, double reference_time) {
  const RecordPeaks record = peaks_between_up_crossings(values);
  const double span = record.steps * step;
  const double expected = span > 0.0 ? static_cast<double>(record.peaks.size()) * reference_time / span : 0.0;
  ExtremeFit fit = fit_peaks(record.peaks, record.mean, expected);
  fit.observed = values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
  if (!fit.enough) {
    fit.weibull = fit.gumbel = {fit.observed, fit.observed, fit.observed};
  }
  return fit;
}

ExtremeFit fit_smallest(std::span<const double> values, double step, double reference_time) {
  std::vector<double> turned(values.size());
  std::transform(values.begin(), values.end(), turned.begin(), std::negate<>());
  ExtremeFit fit = fit_extremes(turned, step, reference_time);
  fit.observed = -fit.observed;
  fit.gumbel_mode = -fit.gumbel_mode;
  for (ConfidentEstimate* estimate : {&fit.weibull, &fit.gumbel}) {
    *estimate = {-estimate->value, -estimate->high, -estimate->low};
  }
  return fit;
}

}  // namespace overbend
