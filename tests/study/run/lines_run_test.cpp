/// Analyses of lines by themselves from the model to the files.
#include "study/run/lines_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <numbers>

#include "base/json.h"
#include "resultfiles/hdf5/hdf5_file.h"
#include "resultfiles/lines/lines_writer.h"
#include "runstore/run_store.h"
#include "support/line_cases.h"
#include "support/memory_sink.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

Description two_chains() {
  Description d = testing::chain_case(50.0, 2.0);
  d.title = "two chains";
  d.lines[0].name = "west";
  d.lines.push_back(d.lines[0]);
  d.lines[1].name = "east";
  d.lines[1].first.at.x() = -400.0;
  d.lines[1].second.amplitude = Vec3::Zero();
  d.lines[0].segments[0].type.breaking_load = 2e6;
  return d;
}

DynamicOptions short_run() {
  DynamicOptions options;
  options.duration = 10.0;
  options.build_up = 10.0;
  return options;
}

DynamicControl go_on(const DynamicProgress&) {
  return DynamicControl::go_on;
}

/// A run whose histories are not kept.
LinesOutcome in_time(const Model& model, const DynamicOptions& options) {
  testing::EmptySink sink;
  return run_lines(model, options, sink, nullptr, go_on);
}

TEST(lines_run, at_rest_tells_both_ends_of_every_line) {
  const Model model = build_model(two_chains());
  const LinesOutcome outcome = solve_lines(model);
  ASSERT_TRUE(outcome.results);
  const std::vector<LineResult>& lines = outcome.results->lines;
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_NEAR(lines[0].second.tension, 1.002e6, 2e3);
  EXPECT_NEAR(lines[0].second.force.x(), -lines[1].second.force.x(), 1e-3);  // mirrored
  EXPECT_NEAR(lines[0].on_bed, 243.8, 5.0);                                  // closed form, to a third of an element
  EXPECT_NEAR(*lines[0].utilisation, 0.501, 1e-3);
  EXPECT_FALSE(lines[1].utilisation);
  // H = T cos of the declination at the fairlead.
  EXPECT_NEAR(lines[0].second.tension * std::cos(lines[0].second.declination), std::abs(lines[0].first.force.x()),
              5e-3 * lines[0].second.tension);
  EXPECT_FALSE(outcome.results->moved);
}

TEST(lines_run, in_time_swings_the_line_whose_end_moves_and_leaves_the_other) {
  const Model model = build_model(two_chains());
  const LinesOutcome outcome = in_time(model, short_run());
  ASSERT_TRUE(outcome.results) << outcome.failure->what;
  const LineResult &west = outcome.results->lines[0], &east = outcome.results->lines[1];
  EXPECT_GT(west.second.in_time.max - west.second.in_time.min, 0.15e6);
  EXPECT_LT(east.second.in_time.max - east.second.in_time.min, 1e2);
  EXPECT_EQ(west.first_history.size(), outcome.results->time.size());
  EXPECT_GE(west.largest_in_time, west.largest_tension);
  EXPECT_LT(std::abs(outcome.results->energy_drift), 1e-3);
}

/// Rows that fall on one phase of the swing alone say nothing of its mean.
TEST(lines_run, has_a_mean_and_a_deviation_that_do_not_hang_on_the_rows) {
  const Model model = build_model(two_chains());
  DynamicOptions options = short_run();
  options.duration = 20.0;
  options.output_step = 0.1;
  const LinesOutcome fine = in_time(model, options);
  options.output_step = 10.0;
  const LinesOutcome coarse = in_time(model, options);
  ASSERT_TRUE(fine.results && coarse.results);
  const Spread &one = fine.results->lines[0].second.in_time, &other = coarse.results->lines[0].second.in_time;
  ASSERT_GT(one.std, 0.0);
  EXPECT_NEAR(other.mean, one.mean, 0.05 * one.std);
  EXPECT_NEAR(other.std, one.std, 0.05 * one.std);
}

TEST(lines_run, takes_the_breaking_load_of_each_segment_over_time) {
  constexpr double kWeak = 205.0;
  Description d = two_chains();
  std::vector<LineSegmentDescription>& segments = d.lines[0].segments;
  segments.push_back(segments.front());
  segments[1].length = *segments[0].length - kWeak;
  segments[0].length = kWeak;
  segments[0].type.breaking_load = 1.2e6;
  const LinesOutcome outcome = in_time(build_model(d), short_run());
  ASSERT_TRUE(outcome.results) << outcome.failure->what;
  const LineResult& west = outcome.results->lines[0];
  double use = 0.0;
  for (const LineNodeResult& node : west.nodes) {
    use = std::max(use, node.largest_tension / (node.s < kWeak + 1e-9 ? 1.2e6 : 2e6));
  }
  ASSERT_TRUE(west.utilisation_in_time);
  EXPECT_NEAR(*west.utilisation_in_time, use, 1e-12);
  EXPECT_GE(*west.utilisation_in_time, *west.utilisation);
  EXPECT_FALSE(outcome.results->lines[1].utilisation_in_time);
}

TEST(lines_run, files_hold_what_was_found) {
  const Description description = two_chains();
  const Model model = build_model(description);
  const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) / "lines_run_test.results";
  const LinesOutcome outcome = run_lines_in(folder, model, short_run(), false, go_on);
  ASSERT_TRUE(outcome.results);
  const Json summary = read_json_file(folder / "summary.json");
  EXPECT_EQ(summary["static"]["lines"][1]["name"], "east");
  EXPECT_NEAR(summary["static"]["lines"][0]["second"]["tension"], 1.002e6, 2e3);
  EXPECT_EQ(summary["dynamic"]["lines"][0]["second_tension"]["max"], outcome.results->lines[0].second.in_time.max);
  EXPECT_TRUE(summary["static"]["lines"][1]["utilisation"].is_null());
  const Hdf5Reader reader(folder / "results.h5");
  EXPECT_EQ(reader.doubles("/lines/0/second_tension"), outcome.results->lines[0].second_history);
  EXPECT_EQ(reader.doubles("/lines/1/nodes/s").size(), outcome.results->lines[1].nodes.size());
  const std::string table = lines_table(*outcome.results);
  EXPECT_EQ(static_cast<std::size_t>(std::count(table.begin(), table.end(), '\n')),
            1 + outcome.results->lines[0].nodes.size() + outcome.results->lines[1].nodes.size());
  EXPECT_EQ(table.find("line,s [m],x [m],y [m],z [m],tension [kN]"), 0u);
  std::filesystem::remove_all(folder);
}

TEST(lines_run, says_which_line_pulls_its_end_off_the_bed) {
  Description d = two_chains();
  d.lines[0].first.kind = d.lines[1].first.kind = LineEndKind::bed;
  d.lines[1].segments[0].length = 401.0;  // the way is 403.1 m
  const LinesOutcome outcome = solve_lines(build_model(d));
  ASSERT_TRUE(outcome.results);
  ASSERT_EQ(outcome.results->findings.size(), 1u);
  EXPECT_NE(messages(outcome.results->findings)[0].find("\"east\": pulls its end on the bed up"), std::string::npos);
}

TEST(lines_run, refuses_an_end_that_leaps_at_the_beginning) {
  Description d = two_chains();
  d.lines[0].second.phase = 0.5 * std::numbers::pi;  // 2 m up at t = 0
  DynamicOptions options = short_run();
  options.build_up = 0.0;
  const LinesOutcome outcome = in_time(build_model(d), options);
  ASSERT_TRUE(outcome.failure);
  EXPECT_EQ(outcome.failure->key, "analysis.dynamic.build_up");
  EXPECT_NE(outcome.failure->why.find("leaps by 2 m"), std::string::npos) << outcome.failure->why;
}

TEST(lines_run, refuses_a_vessel_that_leaps_or_whose_record_ends_before_the_run) {
  Description d = two_chains();
  d.lines[0].second.kind = LineEndKind::body;
  d.vessel.motion = VesselMotion::harmonic;
  d.vessel.harmonic["heave"] = {1.0, 10.0, 0.5 * std::numbers::pi};
  DynamicOptions options = short_run();
  options.build_up = 0.0;
  LinesOutcome outcome = in_time(build_model(d), options);
  ASSERT_TRUE(outcome.failure);
  EXPECT_NE(outcome.failure->why.find("leaps by 1 m"), std::string::npos) << outcome.failure->why;
  d.vessel.motion = VesselMotion::history;
  d.vessel.history.emplace();
  for (int i = 0; i <= 9; ++i) {
    d.vessel.history->time.push_back(i);
    d.vessel.history->freedoms.push_back({});
  }
  outcome = in_time(build_model(d), short_run());  // of 10 s
  ASSERT_TRUE(outcome.failure);
  EXPECT_EQ(outcome.failure->key, "vessel.motion.history");
}

bool has_warning(const LinesResults& results, const std::string& words) {
  return std::ranges::any_of(messages(results.findings),
                             [&](const std::string& told) { return told.find(words) != std::string::npos; });
}

TEST(lines_run, warns_of_a_breaking_load_that_is_exceeded_in_time_alone) {
  Description d = two_chains();
  d.lines[0].segments[0].type.breaking_load = 1.05e6;  // 1,002 kN at rest, some 1,100 kN in time
  const LinesOutcome outcome = in_time(build_model(d), short_run());
  ASSERT_TRUE(outcome.results);
  EXPECT_LT(*outcome.results->lines[0].utilisation, 1.0);
  EXPECT_TRUE(has_warning(*outcome.results, "line \"west\": its largest tension of the run is 1.0"));
  EXPECT_FALSE(has_warning(*outcome.results, "compression"));
}

/// Two chains in a sea, with a run of ten seconds.
Description chains_in_waves() {
  Description d = two_chains();
  d.environment.waves.type = WaveType::jonswap;
  d.environment.waves.hs = 2.0;
  d.environment.waves.tp = 8.0;
  d.environment.waves.components = 20;
  d.dynamics = DynamicSettings{};
  d.dynamics->duration = 4.0;
  d.dynamics->build_up = 2.0;
  return d;
}

TEST(lines_run, warns_of_a_sea_that_the_vessels_raos_do_not_reach) {
  Description d = chains_in_waves();
  d.lines[0].second.kind = LineEndKind::body;
  d.vessel.motion = VesselMotion::raos;
  d.vessel.raos.emplace();
  d.vessel.raos->omegas = {0.1, 0.3};
  d.vessel.raos->headings = {0.0, std::numbers::pi};
  d.vessel.raos->values.assign(2 * 2 * 6, 0.0);
  const Model model = build_model(d);
  const LinesOutcome outcome = in_time(model, dynamic_options(model));
  ASSERT_TRUE(outcome.results) << outcome.failure->what;
  EXPECT_TRUE(has_warning(*outcome.results, "lies above the highest frequency of the RAOs"));
}

TEST(lines_run, stopped_and_taken_up_again_gives_the_same_bits) {
  const Model model = build_model(chains_in_waves());
  const DynamicOptions options = dynamic_options(model);
  const testing::TemporaryFolder folder;
  const LinesOutcome whole = run_lines_in(folder / "whole", model, options, false, go_on);
  ASSERT_TRUE(whole.results);
  const auto stop = [](const DynamicProgress& at) {
    return at.time >= 1.0 ? DynamicControl::stop : DynamicControl::go_on;
  };
  EXPECT_TRUE(run_lines_in(folder / "parts", model, options, false, stop).stopped);
  EXPECT_TRUE(RunStore::find(folder / "parts"));
  double first = 1e9;
  const LinesOutcome rest = run_lines_in(folder / "parts", model, options, true, [&](const DynamicProgress& at) {
    first = std::min(first, at.time);
    return DynamicControl::go_on;
  });
  ASSERT_TRUE(rest.results);
  EXPECT_GT(first, 1.0);
  EXPECT_EQ(lines_values(*rest.results), lines_values(*whole.results));
  EXPECT_EQ(rest.results->time, whole.results->time);
  EXPECT_EQ(rest.results->lines[0].second_history, whole.results->lines[0].second_history);
  EXPECT_EQ(rest.results->energy_drift, whole.results->energy_drift);
  EXPECT_EQ(rest.results->steps, whole.results->steps);
  EXPECT_FALSE(RunStore::find(folder / "parts"));
  EXPECT_TRUE(std::filesystem::exists(folder / "parts" / "summary.json"));
}

TEST(lines_run, a_run_of_another_model_is_not_taken_up) {
  Description d = chains_in_waves();
  const testing::TemporaryFolder folder;
  const Model model = build_model(d);
  const auto stop = [](const DynamicProgress&) { return DynamicControl::stop; };
  EXPECT_TRUE(run_lines_in(folder.path(), model, dynamic_options(model), false, stop).stopped);
  d.source_text = "another";
  const Model other = build_model(d);
  EXPECT_THROW(run_lines_in(folder.path(), other, dynamic_options(other), true, go_on), std::runtime_error);
}

TEST(lines_run, a_seed_that_fails_leaves_the_others_their_results) {
  const Description d = chains_in_waves();
  const Model model = build_model(d);
  const auto run = [&](std::uint64_t seed, const std::string&) {
    if (seed == 2) return LinesOutcome{std::nullopt, StaticFailure{"a step cannot be solved", "", ""}};
    DynamicOptions options = dynamic_options(model);
    options.seed = seed;
    return in_time(model, options);
  };
  const LineSeeds all = run_line_seeds(d, {1, 2, 3}, run);
  EXPECT_FALSE(all.failure);
  ASSERT_EQ(all.seeds.runs.size(), 2U);
  EXPECT_EQ(all.seeds.runs[1].folder, "seed-3");
  ASSERT_EQ(all.seeds.failed.size(), 1U);
  EXPECT_EQ(all.seeds.failed[0].seed, 2U);
  EXPECT_NE(all.seeds.failed[0].why.find("a step cannot be solved"), std::string::npos);
  EXPECT_TRUE(run_line_seeds(d, {2}, run).failure);
}

TEST(lines_run, seeds_are_told_together) {
  const Description d = chains_in_waves();
  const std::vector<SeedRun> runs = {{1, "seed-1", {9e5, 8e5, 1.1e6, 0.9e6, 8e5, 0, 0, 0, 0, 0}, {}},
                                     {2, "seed-2", {9.5e5, 7e5, 1.3e6, 0.8e6, 7e5, 0, 0, 0, 0, 0}, {}}};
  const SeedsResults seeds = gather_lines(d, runs);
  ASSERT_EQ(seeds.quantities.size(), 10U);
  EXPECT_EQ(seeds.quantities[2].name, "west/second_tension_max");
  EXPECT_EQ(seeds.statistics[2].max, 1.3e6);
  EXPECT_EQ(seeds.statistics[3].min, 0.8e6);
  const testing::TemporaryFolder folder;
  LinesResults one;
  one.title = "two chains";
  write_lines_seeds(one, seeds, folder.path());
  const Json summary = read_json_file(folder / "summary.json");
  EXPECT_EQ(summary["seeds"]["statistics"]["west/second_tension_max"]["mean"], 1.2e6);
  EXPECT_TRUE(std::filesystem::exists(folder / "seeds.csv"));
}

}  // namespace
}  // namespace overbend
