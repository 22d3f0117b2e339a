#include "numerics/extremes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "base/ranges.h"
#include "numerics/pareto_tail.h"
#include "numerics/tail_check.h"

namespace overbend {
namespace {

constexpr std::size_t kMinBlocks = 10;
/// Maximum distance of the upper half of a Weibull sample from its fit, for any size: exceeded by 3 % of samples.
constexpr double kMaxDistance = 0.8;
constexpr double kMinProbability = 0.01;    ///< Minimum probability of the largest values.
constexpr std::size_t kMaxTestedPeaks = 5;  ///< Number of largest values tested.
constexpr double kRare = 0.5;               ///< Minimum fraction of cycles that reach the minimum for rare events.
constexpr double kRareShare = 8.0;          ///< Peaks of rare events are at most one in this many.
/// Maximum width of a good interval, over the distance of the estimate from the mean.
constexpr double kGoodWidth = 0.6;
constexpr double kUsefulWidth = 1.5;  ///< Maximum width of a useful interval, likewise.
/// Minimum number of clusters over the threshold of a good generalised Pareto tail.
constexpr std::size_t kGoodClusters = 30;

/// True if the peaks of `tail`, ascending logarithms of distances from the mean, are consistent with the upper part of
/// a sample.
bool describes(const LogWeibull& fit, std::span<const double> tail, std::size_t below) {
  const auto above = [&](double y) { return std::exp(-std::exp((y - fit.location) / fit.scale)); };
  const double lowest = above(tail.front());
  std::vector<double> shares, expected;
  for (const double y : tail.subspan(1)) shares.push_back(1.0 - above(y) / lowest);
  const double n = static_cast<double>(tail.size() + below);
  for (std::size_t i = 0; i < std::min(kMaxTestedPeaks, tail.size()); ++i) {
    expected.push_back(n * above(tail[tail.size() - 1 - i]));
  }
  return upper_tail_distance(shares) < kMaxDistance && min_probability(expected) > kMinProbability;
}

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
  fit.weibull_describes = describes(*log_weibull, tail, below);
  // 1 - F(x) = 1/n
  const ConfidentEstimate log = confident(*log_weibull, tail.size(), below, std::log(std::log(expected_peaks)));
  fit.weibull = {mean + std::exp(log.value), mean + std::exp(log.low), mean + std::exp(log.high)};
}

void fit_gumbel(ExtremeFit& fit, std::span<const double> peaks, double expected_peaks) {
  const double root = std::sqrt(static_cast<double>(peaks.size()));
  const std::size_t blocks = std::max(kMinBlocks, static_cast<std::size_t>(std::lround(root)));
  const std::size_t each = peaks.size() / blocks;
  fit.peaks_per_block = static_cast<int>(each);
  std::vector<double> turned;  // a negated Gumbel variable is distributed as the logarithm of a Weibull variable
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
  // The maximum of r blocks has its mode at mode + scale ln r.
  const double ratio = expected_peaks / static_cast<double>(each);
  const ConfidentEstimate minimum = confident(*gumbel, turned.size(), 0, -std::log(ratio));
  fit.gumbel = {-minimum.value, -minimum.high, -minimum.low};
}

/// Returns the peak whose rank in the record corresponds to an expected `times` exceedances of the estimate, plus one.
double peak_at_rank(std::span<const double> peaks, double times) {
  std::vector<double> sorted(peaks.begin(), peaks.end());
  const auto rank = std::min(static_cast<std::size_t>(times), sorted.size() - 1);
  ranges::nth_element(sorted, sorted.begin() + static_cast<std::ptrdiff_t>(rank), std::greater<>());
  return sorted[rank];
}

void raise_to(double floor, ConfidentEstimate& estimate) {
  estimate.value = std::max(estimate.value, floor);
  estimate.high = std::max(estimate.high, estimate.value);
}

ExtremeQuality rate_quality(const ConfidentEstimate& estimate, double mean) {
  const double width = (estimate.high - estimate.low) / (estimate.value - mean);
  return width < kGoodWidth     ? ExtremeQuality::good
         : width < kUsefulWidth ? ExtremeQuality::uncertain
                                : ExtremeQuality::none;
}

void set_estimate_quality(ExtremeFit& fit, ExtremeQuality quality, ExtremeDoubt doubt) {
  fit.quality = quality;
  fit.doubt = quality == ExtremeQuality::good ? ExtremeDoubt::none : doubt;
  if (quality == ExtremeQuality::none) fit.method = ExtremeMethod::none;
}

/// Estimate for rare events: only a record as long as the reference time contains them.
void choose_rare(ExtremeFit& fit, std::span<const double> peaks, double expected_peaks) {
  constexpr double kRetryResidual = 0.99, kLonger = 1.5;  // a record begins and ends with crossings
  const double times = static_cast<double>(peaks.size()) / expected_peaks;
  const auto tail = fit_pareto_tail(peaks, static_cast<std::size_t>(static_cast<double>(peaks.size()) / kRareShare));
  if (tail) fit.pareto = confident(*tail, expected_peaks);
  if (times < kRetryResidual) return set_estimate_quality(fit, ExtremeQuality::none, ExtremeDoubt::rare);
  fit.method = tail && tail->described ? ExtremeMethod::pareto : ExtremeMethod::observed;
  fit.estimate = tail ? *fit.pareto : fit.estimate;
  raise_to(times < kLonger ? fit.observed : peak_at_rank(peaks, times), fit.estimate);
  fit.estimate.high = std::max(fit.estimate.high, fit.observed);
  set_estimate_quality(fit, ExtremeQuality::uncertain, ExtremeDoubt::rare);
}

void choose_pareto(ExtremeFit& fit, std::span<const double> peaks, double mean, double expected_peaks) {
  const auto tail = fit_pareto_tail(peaks, peaks.size());
  if (!tail || !tail->described) return set_estimate_quality(fit, ExtremeQuality::none, ExtremeDoubt::no_tail);
  fit.pareto = fit.estimate = confident(*tail, expected_peaks);
  fit.method = ExtremeMethod::pareto;
  const ExtremeQuality quality = rate_quality(fit.estimate, mean);
  const bool few = tail->clusters < kGoodClusters;
  set_estimate_quality(fit, few ? std::max(quality, ExtremeQuality::uncertain) : quality, ExtremeDoubt::wide);
}

/// True if the larger half of the peaks are equal, up to the sampling of a crest.
bool are_alike(std::span<const double> peaks, double mean) {
  constexpr double kAlike =
      0.02;  // relative to their height; a crest sampled by 20 rows per period is up to 1.2 % higher than its row
  std::vector<double> sorted(peaks.begin(), peaks.end());
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  ranges::nth_element(sorted, middle);
  const double max_peak = ranges::max(peaks);
  return max_peak - *middle <= kAlike * (max_peak - mean);
}

/// Chooses among the available estimates, and rates the result.
void choose(ExtremeFit& fit, std::span<const double> peaks, double mean, double expected_peaks, bool rare) {
  if (are_alike(peaks, mean)) {
    fit.method = ExtremeMethod::regular;
    return set_estimate_quality(fit, ExtremeQuality::good, ExtremeDoubt::none);
  }
  if (rare) {
    choose_rare(fit, peaks, expected_peaks);
  } else if (fit.weibull_describes) {
    fit.method = ExtremeMethod::weibull;
    fit.estimate = fit.weibull;
    set_estimate_quality(fit, rate_quality(fit.estimate, mean), ExtremeDoubt::wide);
  } else {
    choose_pareto(fit, peaks, mean, expected_peaks);
  }
  if (fit.method == ExtremeMethod::none) {
    fit.estimate = {fit.observed, fit.observed, fit.observed};
  } else if (static_cast<double>(peaks.size()) < 0.5 * expected_peaks) {
    raise_to(fit.observed, fit.estimate);
  }
}

/// Returns the fraction of the cycles between up-crossings that reach the minimum of the record.
double compute_fraction_at_minimum(std::span<const double> values, std::span<const std::size_t> crossings) {
  constexpr double kSame = 1e-6;  // relative to the range
  if (crossings.size() < 2) return 0.0;
  const auto [min_value, max_value] = ranges::minmax(values);
  int down = 0;
  for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
    const auto cycle = values.subspan(crossings[i], crossings[i + 1] - crossings[i]);
    down += ranges::min(cycle) <= min_value + kSame * (max_value - min_value);
  }
  return static_cast<double>(down) / static_cast<double>(crossings.size() - 1);
}

}  // namespace

RecordPeaks peaks_between_up_crossings(std::span<const double> values) {
  RecordPeaks record;
  if (values.empty()) {
    return record;
  }
  record.mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  std::vector<std::size_t> crossings;
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (values[i - 1] < record.mean && values[i] >= record.mean) crossings.push_back(i);
  }
  if (crossings.empty()) return record;
  for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
    record.peaks.push_back(ranges::max(values.subspan(crossings[i], crossings[i + 1] - crossings[i])));
  }
  record.steps = static_cast<double>(crossings.back() - crossings.front());
  record.fraction_at_minimum = compute_fraction_at_minimum(values, crossings);
  return record;
}

ExtremeFit fit_peaks(std::span<const double> peaks, double mean, double expected_peaks, bool rare) {
  ExtremeFit fit;
  fit.peaks = static_cast<int>(peaks.size());
  fit.observed = peaks.empty() ? mean : *std::max_element(peaks.begin(), peaks.end());
  fit.estimate = fit.weibull = fit.gumbel = {fit.observed, fit.observed, fit.observed};
  fit.enough = fit.peaks >= kMinPeaks && expected_peaks > 1.0;
  if (fit.enough) {
    fit_weibull(fit, peaks, mean, expected_peaks);
    fit_gumbel(fit, peaks, expected_peaks);
    choose(fit, peaks, mean, expected_peaks, rare);
  }
  return fit;
}

ExtremeFit fit_extremes(std::span<const double> values, double step, double reference_time) {
  const RecordPeaks record = peaks_between_up_crossings(values);
  const double span = record.steps * step;
  const double expected = span > 0.0 ? static_cast<double>(record.peaks.size()) * reference_time / span : 0.0;
  ExtremeFit fit = fit_peaks(record.peaks, record.mean, expected, record.fraction_at_minimum > kRare);
  fit.observed = values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
  if (static_cast<double>(record.peaks.size()) < expected) {  // a longer time has no smaller maximum
    raise_to(fit.observed, fit.weibull);
    raise_to(fit.observed, fit.gumbel);
  }
  const ConfidentEstimate observed{fit.observed, fit.observed, fit.observed};
  if (!fit.enough) fit.weibull = fit.gumbel = observed;
  if (fit.method == ExtremeMethod::none) fit.estimate = observed;
  return fit;
}

ExtremeFit fit_minimum(std::span<const double> values, double step, double reference_time) {
  std::vector<double> turned(values.size());
  std::transform(values.begin(), values.end(), turned.begin(), std::negate<>());
  ExtremeFit fit = fit_extremes(turned, step, reference_time);
  fit.observed = -fit.observed;
  fit.gumbel_mode = -fit.gumbel_mode;
  const auto turn = [](ConfidentEstimate& estimate) { estimate = {-estimate.value, -estimate.high, -estimate.low}; };
  turn(fit.estimate);
  turn(fit.weibull);
  turn(fit.gumbel);
  if (fit.pareto) turn(*fit.pareto);
  return fit;
}

}  // namespace overbend
