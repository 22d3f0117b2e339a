/// A run in a RunStore, and what must come out of it again.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "runstore/run_store.h"
#include "support/solved_case.h"

namespace overbend::testing::stored_run {

namespace fs = std::filesystem;

inline const std::string kModel = "title: a model\n";
inline constexpr std::uint64_t kSeed = 0xfedcba9876543210ULL;
inline constexpr int kStations = 3;

inline const std::vector<HistoryColumn>& columns() {
  static const std::vector<HistoryColumn> all = {{"time", "s", "Time", false, false},
                                                 {"top_tension", "N", "Tension", true, true},
                                                 {"support/box 8/reaction", "N", "Reaction", true, false}};
  return all;
}

inline void give_row(RunStore& store, int i) {
  const std::array<double, 3> values = {0.5 * i, std::sin(i), 1e3 / (1 + i)};
  store.row(values);
}

inline void give_snapshot(RunStore& store, int i) {
  std::array<double, 5 * kStations + 12> values{};
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = i + 0.01 * static_cast<double>(k);
  store.snapshot(0.5 * i, values);
}

inline Impact impact(int i) {
  return {i, 0.25 * i, 0.1, 1e5 + i, 0.02, 900.0, 1e-4, 2e6};
}

inline DynamicCheckpoint state(int i) {
  return {0.5 * i, {{"q", {1.0 / 3.0, -0.0, std::numeric_limits<double>::denorm_min(), 1.0 * i}}, {"none", {}}}};
}

/// Rows, snapshots and impacts number `from` to `to`.
inline void give(RunStore& store, int from, int to) {
  for (int i = from; i < to; ++i) {
    give_row(store, i);
    if (i % 10 == 0) give_snapshot(store, i);
    if (i % 5 == 0) store.impact(impact(i));
  }
}

/// A run that has come to row 100 and was stopped at 130.
inline void stop_a_run(const fs::path& folder) {
  RunStore store = RunStore::create(folder, kModel, kSeed);
  store.begin(columns(), {kStations, 0});
  give(store, 0, 100);
  store.checkpoint(state(100));
  give(store, 100, 130);
}

inline void expect_rows(const RunStore& store, int count) {
  ASSERT_EQ(store.rows(), count);
  const std::vector<double> time = store.column(0), tension = store.column(1), reaction = store.column(2);
  ASSERT_EQ(time.size(), static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    ASSERT_EQ(time[k], 0.5 * i);
    ASSERT_EQ(tension[k], std::sin(i));
    ASSERT_EQ(reaction[k], 1e3 / (1 + i));
  }
}

inline void expect_run(const RunStore& store, int rows) {
  expect_rows(store, rows);
  ASSERT_EQ(store.snapshots(), (rows + 9) / 10);
  ASSERT_EQ(store.impacts(), (rows + 4) / 5);
  const std::vector<Impact> impacts = store.impact_block(1, store.impacts() - 1);
  EXPECT_EQ(impacts.back().roller, 5 * (store.impacts() - 1));
  EXPECT_EQ(impacts.front().peak_force, 1e5 + 5);
  EXPECT_EQ(impacts.front().line_load, 2e6);
  const std::vector<double> block = store.snapshot_block(1, 2);
  ASSERT_EQ(block.size(), 2U * static_cast<std::size_t>(store.snapshot_size()));
  EXPECT_EQ(block[0], 5.0);
  EXPECT_EQ(block[1], 10.0);
  EXPECT_EQ(block.back(), 20.0 + 0.01 * (5 * kStations + 11));
}

/// Returns the message thrown by resuming.
inline std::string find_run_error(const fs::path& folder, const std::string& model = kModel,
                                  std::uint64_t seed = kSeed) {
  try {
    RunStore::resume(folder, model, seed);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

}  // namespace overbend::testing::stored_run
