#include "numerics/acer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "numerics/acer_tail.h"

namespace overbend {
namespace {

constexpr double kNormal975 = 1.959963984540054;  ///< 97.5 % point of the normal distribution.
constexpr int kFewestParts = 20;                  ///< Of the records, whose scatter gives the confidence.
constexpr int kLevels = 25;
constexpr std::size_t kFewestLevels = 8;
constexpr double kTailFraction = 0.5;  ///< Of the peaks, that lie above the lowest level.
/// Average change of the logarithm of the rates by higher orders, over half their confidence interval.
constexpr double kSettled = 0.1;
constexpr double kWidest = 1.0;  ///< Half of a confidence interval over its rate, up to which a level counts.

/// Peaks that exceed a level after k - 1 below it, and those that had the chance to: of one part of a record.
struct Count {
  double exceeding = 0.0, able = 0.0;
};

/// The counts of `parts` successive parts of a record, added to `counts`.
void count_record(const PeakRecord& record, int order, double level, std::size_t parts, std::vector<Count>& counts) {
  const std::size_t n = record.peaks.size();
  const std::size_t first = counts.size();
  counts.resize(first + parts);
  int below = 0;  // how many peaks in a row have been
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
  const std::size_t each = (kFewestParts + records.size() - 1) / records.size();
  std::vector<Count> counts;
  for (const PeakRecord& record : records) count_record(record, order, level, each, counts);
  return counts;
}

/// Standard error of the ratio of sums, from the scatter of the parts.
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
  if (!(half < kWidest * rate)) return std::nullopt;
  return AcerLevel{level, rate, rate - half, rate + half};
}

/// From the level that kTailFraction of the peaks exceed to the largest peak, evenly spaced.
std::vector<double> tail_levels(std::span<const PeakRecord> records) {
  std::vector<double> all;
  for (const PeakRecord& record : records) all.insert(all.end(), record.peaks.begin(), record.peaks.end());
  const auto from = all.begin() + static_cast<std::ptrdiff_t>((1.0 - kTailFraction) * static_cast<double>(all.size()));
  std::nth_element(all.begin(), from, all.end());
  // The fourth largest: above it too few exceed for any confidence.
  const double low = *from;
  std::nth_element(all.begin(), all.end() - 4, all.end());
  const double high = *(all.end() - 4);
  std::vector<double> levels;
  for (int i = 0; i < kLevels; ++i) levels.push_back(low + (high - low) * i / kLevels);
  return levels;
}

/// Whether the rates of a higher order lie within the confidence of these, on average over the levels of both.
bool agrees(const std::vector<AcerLevel>& rates, const std::vector<AcerLevel>& higher) {
  double difference = 0.0, width = 0.0;
  for (const AcerLevel& other : higher) {
    const auto at = std::ranges::find(rates, other.level, &AcerLevel::level);
    if (at == rates.end()) continue;
    difference += std::log(at->rate / other.rate);
    width += 0.5 * std::log(at->high / at->low);
  }
  return std::abs(difference) <= kSettled * width;
}

/// The least order whose rates all higher ones agree with.
int settled_order(const std::vector<std::vector<AcerLevel>>& rates) {
  for (std::size_t k = 0; k < rates.size(); ++k) {
    const bool settled = std::all_of(rates.begin() + static_cast<std::ptrdiff_t>(k) + 1, rates.end(),
                                     [&](const auto& higher) { return agrees(rates[k], higher); });
    if (settled) return static_cast<int>(k) + 1;
  }
  return static_cast<int>(rates.size());
}

/// 97.5 % point of Student's distribution; within 0.01 from nineteen degrees of freedom on.
double student_975(double freedom) {
  return kNormal975 + 2.5 / freedom;
}

/// The rates at the same levels without one of the parts; those that nothing else exceeds left out.
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

/// The estimate with its interval by the jackknife (Tukey 1958): the tail fitted again without each part in turn.
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
  for (const double other : others) mean += other / count;
  for (const double other : others) squares += (other - mean) * (other - mean);
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
    if (!seen && rates.empty()) continue;  // at low levels few have all peaks before them below
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
  if (fit.peaks < kFewestAcerPeaks || !(time > 0.0)) return std::nullopt;
  const std::vector<double> levels = tail_levels(records);
  if (!(levels.back() > levels.front())) return std::nullopt;
  std::vector<std::vector<AcerLevel>> rates;
  for (int k = 1; k <= kAcerOrders; ++k) rates.push_back(exceedance_rates(records, k, levels));
  fit.order = settled_order(rates);
  fit.levels = rates[static_cast<std::size_t>(fit.order) - 1];
  if (fit.levels.size() < kFewestLevels) return std::nullopt;
  const std::optional<AcerTail> tail = fit_acer_tail(fit.levels);
  if (!tail) return std::nullopt;
  fit.tail = *tail;
  fit.expected_peaks = fit.peaks * reference_time / time;
  const std::optional<ConfidentEstimate> estimate = estimated(records, fit);
  if (!estimate) return std::nullopt;
  fit.estimate = *estimate;
  return fit;
}

std::optional<AcerFit> fit_acer_smallest(std::span<const PeakRecord> records, double reference_time) {
  std::optional<AcerFit> fit = fit_acer(records, reference_time);
  if (!fit) return fit;
  fit->observed = -fit->observed;
  fit->estimate = {-fit->estimate.value, -fit->estimate.high, -fit->estimate.low};
  for (AcerLevel& level : fit->levels) level.level = -level.level;
  return fit;
}

}  // namespace overbend
