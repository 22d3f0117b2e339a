#include "runstore/dynamic_histories.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "base/require.h"

namespace overbend {
namespace {

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

/// First row with t >= 0, with a tolerance for rounding of the clock.
std::size_t start_of_statistics(std::span<const double> time) {
  const double tolerance = time.size() < 2 ? 0.0 : 1e-6 * (time[1] - time[0]);
  return static_cast<std::size_t>(std::lower_bound(time.begin(), time.end(), -tolerance) - time.begin());
}

/// Two passes, so that a small deviation from a large mean keeps its digits.
SummaryStatistics compute_statistics(std::span<const double> all) {
  if (all.empty()) return {};
  std::vector<double> values;
  std::copy_if(all.begin(), all.end(), std::back_inserter(values), [](double value) { return !std::isnan(value); });
  if (values.empty()) return {kMissing, kMissing, kMissing, kMissing};
  const auto count = static_cast<double>(values.size());
  SummaryStatistics spread{values[0], values[0], 0.0, 0.0};
  for (const double value : values) {
    spread.min = std::min(spread.min, value);
    spread.max = std::max(spread.max, value);
    spread.mean += (value - values[0]) / count;
  }
  spread.mean += values[0];
  double squares = 0.0;
  for (const double value : values) squares += (value - spread.mean) * (value - spread.mean);
  spread.std = std::sqrt(squares / count);
  return spread;
}

/// Minimum and maximum of the values that are not missing.
std::pair<double, double> min_and_max(std::span<const double> values) {
  double low = kMissing, high = kMissing;
  for (const double value : values) {
    low = std::fmin(low, value);
    high = std::fmax(high, value);
  }
  return {low, high};
}

}  // namespace

HistorySummary summarise_history(const HistoryColumn& column, std::span<const double> time,
                                 std::span<const double> values) {
  require(time.size() == values.size(), "a history has a value for each time");
  HistorySummary summary{column.name, column.units, column.description, {}, {}, {}};
  summary.over_time = compute_statistics(values.subspan(start_of_statistics(time)));
  const std::size_t stretches = std::min(kMaxIntervals, values.size());
  for (std::size_t i = 0; i < stretches; ++i) {
    const std::size_t begin = i * values.size() / stretches, end = (i + 1) * values.size() / stretches;
    const auto [low, high] = min_and_max(values.subspan(begin, end - begin));
    summary.low.push_back(low);
    summary.high.push_back(high);
  }
  return summary;
}

std::vector<HistorySummary> summarise_histories(const RunStore& store) {
  std::vector<HistorySummary> summaries;
  const std::vector<double> time = store.column(0);
  for (std::size_t i = 1; i < store.columns().size(); ++i) {
    summaries.push_back(summarise_history(store.columns()[i], time, store.column(i)));
  }
  return summaries;
}

}  // namespace overbend
