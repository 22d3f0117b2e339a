#include "numerics/acer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/ranges.h"
#include "numerics/acer_tail.h"

namespace overbend {
namespace {

constexpr double kNormal975 = 1.959963984540054;  ///< 97.5 % point of the normal distribution.
constexpr int kMinParts = 20;  ///< Minimum number of parts of the records whose scatter gives the confidence.
constexpr int kLevels = 25;
constexpr std::size_t kMinLevels = 8;
constexpr double kTailFraction = 0.5;  ///< Fraction of the peaks above the lowest level.
/// Mean change of the logarithm of the rates by higher orders, over half their confidence interval.
constexpr double kSettled = 0.1;
constexpr double kMaxRelativeWidth =
    1.0;  ///< Maximum ratio of half the confidence interval to the rate for a level to count.

/// Number of peaks that exceed a level after k - 1 below it, and number of peaks with k - 1 below it before them: of
/// one part of a record.
struct Count {
  double exceeding = 0.0, able = 0.0;
};

/// Adds the counts of `parts` successive parts of a record to `counts`.
void count_record(const PeakRecord& record, int order, double level, std::size_t parts, std::vector<Count>& counts) {
  const std::size_t n = record.peaks.size();
  const std::size_t first = counts.size();
  counts.resize(first + parts);
  int below = 0;  // number of successive peaks below the level
  for (std::size_t i = 0; i < n; ++i) {
    const bool exceeds = record.peaks[i] > level;
    if (static_cast<int>(i) >= order - 1 && below >= order - 1) {
      Count& count = counts[first + i * parts / n];
      count.able += 1.0;
      if (exceeds) count.exceeding += 1.0;
    }
    below = exceeds ? 0 : below + 1;
  }
}

std::vector<Count> count_all(std::span<const PeakRecord> records, int order, double level) {
  const std::size_t each = (kMinParts + records.size() - 1) / records.size();
  std::vector<Count> counts;
  for (const PeakRecord& record : records) count_record(record, order, level, each, counts);
  return counts;
}

/// Returns the standard error of the ratio of sums, from the scatter of the parts.
double standard_error(const std::vector<Count>& counts, const Count& sum) {
  const double rate = sum.exceeding / sum.able;
  const double parts = static_cast<double>(counts.size());
  double squares = 0.0;
  for (const Count& count : counts) {
    const double residual = count.exceeding - rate * count.able;
    squares += residual * residual;
  }
  return std::sqrt(squares * parts / (parts - 1.0)) / sum.able;
}

std::optional<AcerLevel> rate_at(std::span<const PeakRecord> records, int order, double level) {
  const std::vector<Count> counts = count_all(records, order, level);
  Count sum;
  for (const Count& count : counts) {
    sum.exceeding += count.exceeding;
    sum.able += count.able;
  }
  if (sum.exceeding <= 0.0) return std::nullopt;
  const double rate = sum.exceeding / sum.able;
  const double independent = rate / std::sqrt(sum.exceeding);
  const double half = kNormal975 * std::max(standard_error(counts, sum), independent);
  if (!(half < kMaxRelativeWidth * rate)) return std::nullopt;
  return AcerLevel{level, rate, rate - half, rate + half};
}

/// Returns levels from the one exceeded by kTailFraction of the peaks to the largest peak, evenly spaced.
std::vector<double> tail_levels(std::span<const PeakRecord> records) {
  std::vector<double> all;
  for (const PeakRecord& record : records) all.insert(all.end(), record.peaks.begin(), record.peaks.end());
  const auto from = all.begin() + static_cast<std::ptrdiff_t>((1.0 - kTailFraction) * static_cast<double>(all.size()));
  std::nth_element(all.begin(), from, all.end());
  // The fourth largest peak: above it there are too few exceedances for any confidence.
  const double low = *from;
  std::nth_element(all.begin(), all.end() - 4, all.end());
  const double high = *(all.end() - 4);
  std::vector<double> levels;
  for (int i = 0; i < kLevels; ++i) levels.push_back(low + (high - low) * i / kLevels);
  return levels;
}

/// True if the rates of a higher order are within the confidence of these, on average over the levels of both.
bool agrees(const std::vector<AcerLevel>& rates, const std::vector<AcerLevel>& higher) {
  double difference = 0.0, width = 0.0;
  for (const AcerLevel& higher_level : higher) {
    const auto rate = ranges::find(rates, higher_level.level, &AcerLevel::level);
    if (rate == rates.end()) continue;
    difference += std::log(rate->rate / higher_level.rate);
    width += 0.5 * std::log(rate->high / rate->low);
  }
  return std::abs(difference) <= kSettled * width;
}

/// Returns the lowest order with which the rates of all higher ones agree.
int settled_order(const std::vector<std::vector<AcerLevel>>& rates) {
  for (std::size_t k = 0; k < rates.size(); ++k) {
    const bool settled = std::all_of(rates.begin() + static_cast<std::ptrdiff_t>(k) + 1, rates.end(),
                                     [&](const auto& higher) { return agrees(rates[k], higher); });
    if (settled) return static_cast<int>(k) + 1;
  }
  return static_cast<int>(rates.size());
}

/// Returns the 97.5 % point of Student's distribution; within 0.01 from nineteen degrees of freedom on.
double student_975(double freedom) {
  return kNormal975 + 2.5 / freedom;
}

/// Returns the rates at the same levels without one of the parts; levels without other exceedances are left out.
std::vector<AcerLevel> without(std::size_t part, const std::vector<std::vector<Count>>& counts,
                               const std::vector<AcerLevel>& levels) {
  std::vector<AcerLevel> left;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    Count sum;
    for (std::size_t j = 0; j < counts[i].size(); ++j) {
      if (j == part) continue;
      sum.exceeding += counts[i][j].exceeding;
      sum.able += counts[i][j].able;
    }
    if (sum.exceeding <= 0.0) break;
    const double factor = sum.exceeding / sum.able / levels[i].rate;
    left.push_back({levels[i].level, factor * levels[i].rate, factor * levels[i].low, factor * levels[i].high});
  }
  return left;
}

/// Returns the estimate with its interval by the jackknife (Tukey 1958): the tail is refitted without each part in
/// turn.
std::optional<ConfidentEstimate> estimated(std::span<const PeakRecord> records, const AcerFit& fit) {
  const double once = 1.0 / fit.expected_peaks;
  if (!(once < fit.tail.q)) return std::nullopt;
  std::vector<std::vector<Count>> counts;
  for (const AcerLevel& level : fit.levels) counts.push_back(count_all(records, fit.order, level.level));
  const std::size_t parts = counts.front().size();
  std::vector<double> others;
  for (std::size_t part = 0; part < parts; ++part) {
    const std::optional<AcerTail> tail = fit_acer_tail(without(part, counts, fit.levels), &fit.tail);
    if (tail && once < tail->q) others.push_back(tail->level(once));
  }
  if (2 * others.size() < parts) return std::nullopt;
  const double count = static_cast<double>(others.size());
  double mean = 0.0, squares = 0.0;
  for (const double level : others) mean += level / count;
  for (const double level : others) squares += (level - mean) * (level - mean);
  const double half = student_975(count - 1.0) * std::sqrt(squares * (count - 1.0) / count);
  const double value = fit.tail.level(once);
  return ConfidentEstimate{value, value - half, value + half};
}

}  // namespace

std::vector<AcerLevel> exceedance_rates(std::span<const PeakRecord> records, int order,
                                        std::span<const double> levels) {
  std::vector<AcerLevel> rates;
  for (const double level : levels) {
    const std::optional<AcerLevel> seen = rate_at(records, order, level);
    if (!seen && rates.empty()) continue;  // at low levels few peaks have all previous peaks below
    if (!seen) break;
    rates.push_back(*seen);
  }
  return rates;
}

std::optional<AcerFit> fit_acer(std::span<const PeakRecord> records, double reference_time) {
  AcerFit fit;
  double time = 0.0;
  fit.observed = -std::numeric_limits<double>::infinity();
  for (const PeakRecord& record : records) {
    fit.peaks += static_cast<int>(record.peaks.size());
    time += record.duration;
    for (const double peak : record.peaks) fit.observed = std::max(fit.observed, peak);
  }
  if (fit.peaks < kMinAcerPeaks || !(time > 0.0)) return std::nullopt;
  const std::vector<double> levels = tail_levels(records);
  if (!(levels.back() > levels.front())) return std::nullopt;
  std::vector<std::vector<AcerLevel>> rates;
  for (int k = 1; k <= kAcerOrders; ++k) rates.push_back(exceedance_rates(records, k, levels));
  fit.order = settled_order(rates);
  fit.levels = rates[static_cast<std::size_t>(fit.order) - 1];
  if (fit.levels.size() < kMinLevels) return std::nullopt;
  const std::optional<AcerTail> tail = fit_acer_tail(fit.levels);
  if (!tail) return std::nullopt;
  fit.tail = *tail;
  fit.expected_peaks = fit.peaks * reference_time / time;
  const std::optional<ConfidentEstimate> estimate = estimated(records, fit);
  if (!estimate) return std::nullopt;
  fit.estimate = *estimate;
  return fit;
}

std::optional<AcerFit> fit_acer_minimum(std::span<const PeakRecord> records, double reference_time) {
  std::optional<AcerFit> fit = fit_acer(records, reference_time);
  if (!fit) return fit;
  fit->observed = -fit->observed;
  fit->estimate = {-fit->estimate.value, -fit->estimate.high, -fit->estimate.low};
  for (AcerLevel& level : fit->levels) level.level = -level.level;
  return fit;
}

}  // namespace overbend
