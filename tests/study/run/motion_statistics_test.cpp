#include "study/run/motion_statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "support/solved_case.h"

namespace overbend {
namespace {

constexpr double kStep = 0.5;

double sine(double t, double period) {
  return std::sin(2.0 * std::numbers::pi * t / period);
}

const std::vector<HistoryColumn>& columns() {
  static const std::vector<HistoryColumn> all = {{"time", "s", "Time"},
                                                 {"vessel/surge", "m", "Forward"},
                                                 {"vessel/sway", "m", "To port"},
                                                 {"mooring/bow/fairlead_tension", "N", "Tension"}};
  return all;
}

/// Sway of 1.5 m in 80 s about 0.7 m with waves of 0.4 m in 10 s; a line that follows it with 20 kN per m.
RunStore make_run(const std::filesystem::path& folder, double build_up, double duration) {
  RunStore store = RunStore::create(folder, "model", 1);
  store.begin(columns(), {0, 0});
  for (int i = 0; kStep * i <= build_up + duration; ++i) {
    const double t = kStep * i - build_up;
    const double sway = 0.7 + 1.5 * sine(t, 80.0) + 0.4 * sine(t, 10.0);
    const std::array<double, 4> row = {t, 0.0, sway, 300e3 + 20e3 * sway};
    store.row(row);
  }
  return store;
}

DynamicResults make_dynamic_results(double build_up, double duration) {
  DynamicResults results;
  results.build_up = build_up;
  results.duration = duration;
  results.output_step = kStep;
  results.vessel.emplace();
  results.vessel->start_sway = 0.2;
  results.vessel->sway.whole = {-1.2, 2.6, 0.7, 1.1};
  MooringLineDynamics line;
  line.name = "bow";
  line.utilisation = 0.2;
  line.fairlead_tension.whole.max = 352e3;
  results.moorings = {line};
  return results;
}

bool warned(const DynamicResults& results, const std::string& message) {
  return std::ranges::any_of(messages(results.findings),
                             [&](const std::string& warning) { return warning.find(message) != std::string::npos; });
}

Description waves_of_ten_seconds() {
  Description d;
  WavesDescription& waves = d.environment.waves.front();
  waves.type = WaveType::jonswap;
  waves.hs = 2.0;
  waves.tp = 10.0;
  return d;
}

TEST(motion_parts, a_sum_of_two_sines_is_reported_as_its_slow_and_its_wave_part) {
  const testing::TemporaryFolder folder;
  RunStore store = make_run(folder.path() / "run", 400.0, 4000.0);
  DynamicResults results = make_dynamic_results(400.0, 4000.0);
  finish_motions({}, waves_of_ten_seconds(), results, store);
  const MotionStatistics& sway = results.vessel->sway;
  EXPECT_NEAR(sway.slow.mean, 0.7, 0.002);
  EXPECT_NEAR(sway.slow.std, 1.5 / std::sqrt(2.0), 0.005);
  EXPECT_NEAR(sway.wave.std, 0.4 / std::sqrt(2.0), 0.002);
  EXPECT_NEAR(sway.slow_cycles, 49.0, 1.0);
  EXPECT_NEAR(sway.wave_cycles, 399.0, 1.0);
  EXPECT_NEAR(*sway.most_probable_max, 0.7 + 1.5 + 0.4, 0.02);  // regular: what it reaches it reaches again
  EXPECT_NEAR(*sway.most_probable_min, 0.7 - 1.5 - 0.4, 0.02);
  EXPECT_NEAR(results.vessel->across.slow.mean, 0.5, 0.002);
  const MotionStatistics& tension = results.moorings.front().fairlead_tension;
  EXPECT_NEAR(tension.slow.std, 20e3 * 1.5 / std::sqrt(2.0), 100.0);
  EXPECT_NEAR(*results.moorings.front().most_probable_utilisation, 0.2 * *tension.most_probable_max / 352e3, 1e-12);
}

TEST(motion_parts, no_distance_and_no_tension_of_a_line_is_reported_below_zero) {
  const testing::TemporaryFolder folder;
  RunStore store = RunStore::create(folder.path() / "run", "model", 1);
  store.begin({{"time", "s", "Time"},
               {"vessel/sway", "m", "To port"},
               {"vessel/offset", "m", "From the start"},
               {"mooring/bow/fairlead_tension", "N", "Tension"},
               {"mooring/bow/anchor_tension", "N", "Tension"}},
              {0, 0});
  DynamicResults results = make_dynamic_results(100.0, 2000.0);
  for (int i = 0; kStep * i <= 2100.0; ++i) {
    const double t = kStep * i - 100.0;
    const double sway = 1.5 * sine(t, 80.0) + 0.9 * sine(t, 10.0);
    // A line of 20 kN at rest that falls slack, and one end of it that was pushed by 3 N while it did.
    const double tension = std::max(20e3 + 20e3 * sway, 0.0);
    const std::array<double, 5> row = {t, sway, std::abs(sway), tension, tension - 3.0};
    store.row(row);
  }
  MooringLineDynamics& line = results.moorings.front();
  line.anchor_tension.whole.min = -3.0;
  finish_motions({}, waves_of_ten_seconds(), results, store);
  EXPECT_LT(*results.vessel->sway.most_probable_min, -2.0);
  EXPECT_EQ(results.vessel->offset.most_probable_min, 0.0);
  EXPECT_EQ(line.fairlead_tension.most_probable_min, 0.0);
  EXPECT_EQ(line.anchor_tension.most_probable_min, -3.0);
}

TEST(motion_parts, the_slow_part_is_a_history_in_addition_to_the_others) {
  const testing::TemporaryFolder folder;
  RunStore store = make_run(folder.path() / "run", 100.0, 1000.0);
  DynamicResults results = make_dynamic_results(100.0, 1000.0);
  finish_motions({}, waves_of_ten_seconds(), results, store);
  std::vector<std::string> names;
  for (const HistoryColumn& column : store.columns()) names.push_back(column.name);
  const auto found = std::find(names.begin(), names.end(), "vessel/slow_sway");
  ASSERT_NE(found, names.end());
  const std::vector<double> slow = store.column(static_cast<std::size_t>(found - names.begin()));
  ASSERT_EQ(slow.size(), static_cast<std::size_t>(store.rows()));
  EXPECT_NEAR(slow[1200], 0.7 + 1.5 * sine(500.0, 80.0), 0.005);
  EXPECT_NE(std::find(names.begin(), names.end(), "mooring/bow/slow_fairlead_tension"), names.end());
}

TEST(motion_parts, a_run_too_short_for_the_slow_motion_is_named) {
  StaticResults statics;
  statics.moorings.emplace();
  statics.moorings->rest.vessel.natural_periods = {{"sway", 77.1}, {"surge", 66.9}, {"heave", 8.0}};
  const testing::TemporaryFolder folder;
  RunStore store = make_run(folder.path() / "short", 200.0, 800.0);
  DynamicResults brief = make_dynamic_results(200.0, 800.0);
  finish_motions(statics, waves_of_ten_seconds(), brief, store);
  EXPECT_TRUE(warned(brief, "slow cycles of sway, fewer than 20"));
  EXPECT_TRUE(warned(brief, "shorter than three natural periods of slow sway (77.1 s each)"));
  RunStore longer = make_run(folder.path() / "long", 240.0, 2400.0);
  DynamicResults enough = make_dynamic_results(240.0, 2400.0);
  finish_motions(statics, waves_of_ten_seconds(), enough, longer);
  EXPECT_TRUE(enough.findings.empty());
}

TEST(motion_parts, of_a_cycle_or_two_no_error_is_reported_that_would_be_none) {
  const testing::TemporaryFolder folder;
  RunStore store = make_run(folder.path(), 10.0, 100.0);
  DynamicResults results = make_dynamic_results(10.0, 100.0);
  finish_motions({}, waves_of_ten_seconds(), results, store);
  EXPECT_NE(results.vessel->confidence.find("too few to estimate"), std::string::npos) << results.vessel->confidence;
  EXPECT_EQ(results.vessel->confidence.find("0 %"), std::string::npos);
}

TEST(motion_parts, the_cut_off_lies_beyond_the_waves) {
  EXPECT_EQ(cut_off_period({}), 20.0);
  WavesDescription swell;
  swell.type = WaveType::airy;
  swell.height = 1.0;
  swell.period = 16.0;
  EXPECT_DOUBLE_EQ(cut_off_period({swell}), 25.6);
  WavesDescription storm = waves_of_ten_seconds().environment.waves.front();
  storm.tp = 14.0;
  // A thousandth of a JONSWAP spectrum lies below 0.6 to 0.75 of its peak's frequency.
  EXPECT_GT(cut_off_period({storm}), 1.3 * 14.0);
  EXPECT_LT(cut_off_period({storm}), 1.9 * 14.0);
}

// A pipeline on the bed runs north at x = 50 m; the line passes over it, 10 m above in the first picture and 7 m in the
// second.
TEST(motion_parts, clearance_is_the_least_of_the_snapshots) {
  const testing::TemporaryFolder folder;
  RunStore store = RunStore::create(folder / "run", "model", 1);
  store.begin(columns(), {0, 2});
  for (int i = 0; i < 3; ++i) store.row(std::array<double, 4>{kStep * i, 0.0, 0.0, 0.0});
  for (const double height : {10.0, 7.0}) {
    std::vector<double> snapshot(12, 0.0);
    snapshot.insert(snapshot.end(), {0.0, 0.0, height - 89.0, 1e5, 100.0, 0.0, height - 89.0, 1e5});
    store.snapshot(height, snapshot);
  }
  DynamicResults results = make_dynamic_results(0.0, 1.0);
  results.moorings.front().points = {0.0, 1.0};
  Description d = waves_of_ten_seconds();
  d.moorings.emplace();
  d.moorings->objects = {{"pipeline", {Vec3(50.0, -100.0, -89.0), Vec3(50.0, 100.0, -89.0)}},
                         {"far", {Vec3(500.0, 0.0, -89.0)}}};
  finish_motions({}, d, results, store);
  EXPECT_DOUBLE_EQ(results.moorings.front().clearance.value(), 7.0);
  EXPECT_EQ(results.moorings.front().nearest_object, "pipeline");
}

TEST(motion_parts, nothing_is_reported_for_a_vessel_that_does_not_float) {
  const testing::TemporaryFolder folder;
  RunStore store = make_run(folder.path() / "run", 10.0, 100.0);
  DynamicResults results;
  results.output_step = kStep;
  finish_motions({}, waves_of_ten_seconds(), results, store);
  EXPECT_FALSE(results.vessel);
  EXPECT_EQ(store.columns().size(), columns().size());
}

}  // namespace
}  // namespace overbend
