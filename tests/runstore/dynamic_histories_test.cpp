#include "runstore/dynamic_histories.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/dynamic_case.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

const HistoryColumn kHeave = {"heave", "m", "Heave of the vessel", false, false};

std::vector<double> clock(std::size_t rows, double start, double step) {
  std::vector<double> time(rows);
  for (std::size_t i = 0; i < rows; ++i) time[i] = start + step * static_cast<double>(i);
  return time;
}

TEST(history_summary, counts_from_t_0_on) {
  const std::vector<double> time = {-1.0, -0.5, 1e-12, 0.5, 1.0, 1.5}, values = {90.0, -90.0, 1.0, 2.0, 3.0, 6.0};
  const HistorySummary summary = summarise_history(kHeave, time, values);
  EXPECT_EQ(summary.over_time.min, 1.0);
  EXPECT_EQ(summary.over_time.max, 6.0);
  EXPECT_DOUBLE_EQ(summary.over_time.mean, 3.0);
  EXPECT_DOUBLE_EQ(summary.over_time.std, std::sqrt(14.0 / 4.0));
  EXPECT_EQ(summary.low, values);  // drawn from the start of the build-up
  EXPECT_EQ(summary.high, values);
  EXPECT_EQ(summary.name + summary.units + summary.description, "heavemHeave of the vessel");
}

TEST(history_summary, does_not_lose_t_0_to_rounding_of_the_clock) {
  std::vector<double> time = clock(5, -0.3, 0.1);  // 0 comes out as 5.6e-17 or its negative
  time[3] = -5.6e-17;
  const HistorySummary summary = summarise_history(kHeave, time, std::vector<double>{9.0, 9.0, 9.0, 2.0, 4.0});
  EXPECT_EQ(summary.over_time.mean, 3.0);
}

TEST(history_summary, gives_a_sine_its_known_statistics) {
  const std::size_t rows = 36'000;
  std::vector<double> values(rows);
  for (std::size_t i = 0; i < rows; ++i) {
    values[i] = 1e6 + 2.0 * std::sin(2.0 * std::numbers::pi * static_cast<double>(i) / 120.0);
  }
  const SummaryStatistics spread = summarise_history(kHeave, clock(rows, 0.0, 0.1), values).over_time;
  // Whole periods: exact but for rounding of 1e6, which has steps of 1.2e-10.
  EXPECT_NEAR(spread.mean, 1e6, 1e-8);
  EXPECT_NEAR(spread.std, std::sqrt(2.0), 1e-8);
  EXPECT_NEAR(spread.max, 1e6 + 2.0, 1e-9);
  EXPECT_NEAR(spread.min, 1e6 - 2.0, 1e-9);
}

TEST(history_summary, keeps_every_peak_in_2000_stretches_at_most) {
  for (const std::size_t rows : {3U, 2000U, 2001U, 3999U, 123'457U}) {
    std::vector<double> values(rows, 0.0);
    values[rows / 3] = 7.0;
    values[rows - 1] = -5.0;
    const HistorySummary summary = summarise_history(kHeave, clock(rows, 0.0, 0.1), values);
    const std::size_t stretches = std::min<std::size_t>(rows, 2000);
    ASSERT_EQ(summary.low.size(), stretches);
    ASSERT_EQ(summary.high.size(), stretches);
    EXPECT_EQ(summary.low.back(), -5.0) << rows;
    EXPECT_EQ(std::ranges::count(summary.high, 7.0), 1) << rows;
  }
}

TEST(history_summary, passes_over_what_is_absent_and_keeps_it_as_a_gap) {
  constexpr double kAbsent = std::numeric_limits<double>::quiet_NaN();
  const HistorySummary summary =
      summarise_history(kHeave, clock(5, 0.0, 0.1), std::vector<double>{5.0, kAbsent, kAbsent, kAbsent, 4.0});
  EXPECT_EQ(summary.over_time.min, 4.0);
  EXPECT_EQ(summary.over_time.max, 5.0);
  EXPECT_DOUBLE_EQ(summary.over_time.mean, 4.5);
  EXPECT_TRUE(std::isnan(summary.low[2]) && std::isnan(summary.high[2]));
  EXPECT_EQ(summary.low[4], 4.0);
  const HistorySummary never = summarise_history(kHeave, clock(2, 0.0, 0.1), std::vector<double>{kAbsent, kAbsent});
  EXPECT_TRUE(std::isnan(never.over_time.mean));
}

TEST(history_summary, is_all_zero_where_there_is_nothing_to_count) {
  const HistorySummary before = summarise_history(kHeave, clock(3, -5.0, 0.1), std::vector<double>{1.0, 2.0, 3.0});
  EXPECT_EQ(before.over_time.max, 0.0);
  EXPECT_EQ(before.high.size(), 3U);
  EXPECT_TRUE(summarise_history(kHeave, {}, {}).low.empty());
}

TEST(history_summaries, follow_the_columns_of_the_run_without_the_time) {
  const testing::TemporaryFolder folder;
  const RunStore store = testing::filled_run(folder.path(), 5000);
  const std::vector<HistorySummary> summaries = summarise_histories(store);
  ASSERT_EQ(summaries.size() + 1, testing::stored_columns().size());
  for (std::size_t i = 0; i < summaries.size(); ++i)
    EXPECT_EQ(summaries[i].name, testing::stored_columns()[i + 1].name);
  EXPECT_NEAR(summaries[1].over_time.max, 1.0, 1e-5);  // sin(2 i) comes that near to 1 in 5000 rows
}

}  // namespace
}  // namespace overbend
