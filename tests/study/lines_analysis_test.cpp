/// Analyses of lines by themselves: the way of every other model, from statics to files, seeds, seeks.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <numbers>

#include "base/json.h"
#include "checks/run_checks.h"
#include "modelfile/reading/yaml_reader.h"
#include "recording/run_dynamics.h"
#include "resultfiles/dynamic/dynamic_reader.h"
#include "resultfiles/hdf5/hdf5_file.h"
#include "runstore/run_store.h"
#include "statics/moored/moored_lay.h"
#include "study/run/dynamic_realisation.h"
#include "study/run/seeds_gather.h"
#include "study/run/static_analysis.h"
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
  d.dynamics = DynamicSettings{};
  d.dynamics->duration = d.dynamics->build_up = 10.0;
  return d;
}

std::shared_ptr<const PreparedCase> prepared(const Description& d) {
  auto made = prepare_case(d);
  if (const RunResult* end = std::get_if<RunResult>(&made)) throw std::runtime_error(end->why);
  return std::get<0>(std::move(made));
}

std::string rejection(const Description& d) {
  const auto made = prepare_case(d);
  return std::holds_alternative<RunResult>(made) ? std::get<RunResult>(made).why : "";
}

DynamicControl go_on(const DynamicProgress&) {
  return DynamicControl::go_on;
}

/// A run whose histories are not kept.
DynamicResults in_time(const PreparedCase& lines) {
  testing::EmptySink sink;
  return run_dynamics(lines.model, lines.start, lines.statics, dynamic_options(lines.model), sink, nullptr, go_on)
      .results.value();
}

RealisationResult run_in(const std::filesystem::path& folder, const PreparedCase& lines, bool resume = false,
                         const std::function<DynamicControl(const DynamicProgress&)>& control = go_on) {
  FileLock files;
  return run_realisation(lines, folder, 1, resume, control, files);
}

bool has_finding(const Findings& findings, const std::string& message) {
  return std::ranges::any_of(messages(findings), [&](const std::string& changed_text) {
    return changed_text.find(message) != std::string::npos;
  });
}

TEST(lines_analysis, at_rest_reports_both_ends_of_every_line) {
  const std::vector<LineResult> lines = solve_lines(build_model(two_chains())).lines;
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_NEAR(lines[0].second.tension, 1.002e6, 2e3);
  EXPECT_NEAR(lines[0].second.force.x(), -lines[1].second.force.x(), 1e-3);  // mirrored
  EXPECT_NEAR(lines[0].on_bed, 243.8, 5.0);                                  // closed form, to a third of an element
  EXPECT_NEAR(*lines[0].utilisation, 0.501, 1e-3);
  EXPECT_FALSE(lines[1].utilisation);
  // H = T cos of the declination at the fairlead.
  EXPECT_NEAR(lines[0].second.tension * std::cos(lines[0].second.declination), std::abs(lines[0].first.force.x()),
              5e-3 * lines[0].second.tension);
}

TEST(lines_analysis, in_time_swings_the_line_whose_end_moves_and_leaves_the_other) {
  const auto lines = prepared(two_chains());
  const DynamicResults run = in_time(*lines);
  const LineDynamics &west = run.lines.at(0), &east = run.lines.at(1);
  EXPECT_GT(west.second_tension.max - west.second_tension.min, 0.15e6);
  EXPECT_LT(east.second_tension.max - east.second_tension.min, 1e2);
  EXPECT_GE(west.max_tension, lines->statics.lines[0].max_tension);
  EXPECT_LT(std::abs(run.energy.drift()), 1e-3);
}

/// Rows that fall on one phase of the swing alone say nothing of its mean.
TEST(lines_analysis, has_a_mean_and_a_deviation_that_do_not_depend_on_the_rows) {
  Description d = two_chains();
  d.dynamics->duration = 20.0;
  const auto with_rows = [&](double step) {
    d.dynamics->output_step = step;
    return in_time(*prepared(d)).lines.at(0).second_tension;
  };
  const SummaryStatistics fine = with_rows(0.1), coarse = with_rows(10.0);  // of the period
  EXPECT_GT(fine.std, 0.05e6);
  EXPECT_NEAR(coarse.mean, fine.mean, 0.02 * fine.mean);
  EXPECT_NEAR(coarse.std, fine.std, 0.05 * fine.std);
}

/// The joint of two segments is the upper's end and the lower's beginning.
TEST(lines_analysis, takes_the_breaking_load_of_each_segment_over_time) {
  constexpr double kWeak = 205.0;
  Description d = two_chains();
  std::vector<LineSegmentDescription>& segments = d.lines[0].segments;
  segments.push_back(segments.front());
  segments[1].length = *segments[0].length - kWeak;
  segments[0].length = kWeak;
  segments[0].type.breaking_load = 1.2e6;
  const auto lines = prepared(d);
  const DynamicResults run = in_time(*lines);
  const LineDynamics& west = run.lines.at(0);
  const std::vector<LineNodeResult>& nodes = lines->statics.lines[0].nodes;
  double use = 0.0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    use = std::max(use, west.max_tension_at_nodes.at(i) / (nodes[i].s < kWeak + 1e-9 ? 1.2e6 : 2e6));
  }
  ASSERT_TRUE(west.utilisation);
  EXPECT_NEAR(*west.utilisation, use, 1e-12);
  EXPECT_GE(*west.utilisation, *lines->statics.lines[0].utilisation);
  EXPECT_FALSE(run.lines.at(1).utilisation);
}

/// A steel pipe 18 m long, upright in the air between ends 18.02 m apart.
const std::string kUprightPipe = R"(overbend: 1
title: A pipe pulled straight
environment: {water_depth: 20 m, water_weight_density: 10.05 kN/m^3, seabed: {stiffness: 100 kN/m^2, friction: 0.3}}
lines:
  - name: riser
    ends: [{fixed: {x: 0 m, y: 0 m, z: 30 m}}, {fixed: {x: 0 m, y: 0 m, z: 11.98 m}}]
    segments:
      - length: 18 m
        steel: {outside_diameter: 0.2191 m, wall_thickness: 0.0127 m, youngs_modulus: 207 GPa, poissons_ratio: 0.3, yield_stress: 414 MPa, weight_density: 77 kN/m^3}
        contents: {weight_density: 0 kN/m^3}
)";

// In the air the stress is the tension over the steel's area: what it is stretched by and half of its weight at the
// top.
TEST(lines_analysis, judges_pipe_between_two_ends_by_its_stress) {
  Model model = build_model(*read_model_text(kUprightPipe, "riser.yaml").description);
  const StaticResults results = run_statics(model, nullptr).results.value();
  const double area = std::numbers::pi * (0.2191 - 0.0127) * 0.0127;
  const double stress = 207e9 * 0.02 / 18.0 + 77e3 * 9.0;
  const auto row = std::ranges::find(results.checks.rows, "dnv_equivalent_stress", &CheckRow::id);
  ASSERT_NE(row, results.checks.rows.end());
  EXPECT_EQ(row->line, "riser");
  EXPECT_NEAR(row->s, 0.0, 1e-9);
  EXPECT_NEAR(row->demand, stress, 1e-6 * stress);
  const auto tension = std::ranges::find(results.checks.rows, "api_tension", &CheckRow::id);
  ASSERT_NE(tension, results.checks.rows.end());
  EXPECT_NEAR(tension->demand, stress * area, 1e-6 * stress * area);
}

// Results of a run without moments: neither passed nor failed.
TEST(lines_analysis, does_not_judge_pipe_of_a_line_over_time_by_its_state_at_rest) {
  Model model = build_model(*read_model_text(kUprightPipe, "riser.yaml").description);
  const StaticResults rest = run_statics(model, nullptr).results.value();
  DynamicResults run;
  run.duration = 10800.0;
  run.lines.resize(1);
  const CheckTable table = check_dynamics(model, rest, run);
  ASSERT_FALSE(table.rows.empty());
  EXPECT_EQ(table.rows.front().line, "riser");
  EXPECT_EQ(table.rows.front().status, CheckStatus::outside_validity);
  EXPECT_EQ(find_governing_check(table), nullptr);
}

TEST(lines_analysis, rejects_a_line_that_cannot_reach) {
  std::string text = kUprightPipe;
  text.replace(text.find("z: 30 m"), 7, "z: 90 m");
  Model model = build_model(*read_model_text(text, "riser.yaml").description);
  const StaticRun run = run_statics(model, nullptr);
  ASSERT_TRUE(run.failure);
  EXPECT_TRUE(run.failure->input);
  EXPECT_EQ(run.failure->key, "lines[0]");
  EXPECT_NE(run.failure->what.find("line \"riser\" cannot reach"), std::string::npos) << run.failure->what;
}

TEST(lines_analysis, files_hold_what_was_found) {
  const testing::TemporaryFolder folder;
  const auto lines = prepared(two_chains());
  const RealisationResult end = run_in(folder.path(), *lines);
  ASSERT_EQ(end.ending, RunStatus::done) << end.why;
  const LineDynamics& west = end.results->lines.at(0);
  const Json summary = read_json_file(folder / "summary.json");
  EXPECT_EQ(summary["static"]["lines"][1]["name"], "east");
  EXPECT_NEAR(summary["static"]["lines"][0]["second"]["tension"], 1.002e6, 2e3);
  EXPECT_EQ(summary["dynamic"]["lines"][0]["second_tension"]["max"], west.second_tension.max);
  EXPECT_TRUE(summary["static"]["lines"][1]["utilisation"].is_null());
  EXPECT_EQ(summary["dynamic"]["checks"]["worst"]["id"], summary["checks"]["worst"]["id"]);
  const Hdf5Reader reader(folder / "results.h5");
  const std::vector<double> history = reader.doubles("/dynamic/histories/line/west/second_tension");
  EXPECT_EQ(reader.doubles("/lines/0/second_tension"), history);
  EXPECT_EQ(reader.doubles("/lines/time").size(), history.size());
  EXPECT_LE(*std::ranges::max_element(history), west.second_tension.max);
  const StoredDynamics stored = read_dynamic_results(folder / "results.h5");
  EXPECT_EQ(stored.results.lines.at(0).max_tension_at_nodes, west.max_tension_at_nodes);
  EXPECT_EQ(stored.statics.results.lines.at(1).nodes.size(), lines->statics.lines[1].nodes.size());
}

TEST(lines_analysis, says_which_line_pulls_its_end_off_the_bed) {
  Description d = two_chains();
  d.lines[0].first.kind = d.lines[1].first.kind = LineEndKind::bed;
  d.lines[1].segments[0].length = 401.0;  // the way is 403.1 m
  const Findings findings = solve_lines(build_model(d)).findings;
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_NE(messages(findings)[0].find("\"east\": lifts its end on the bed"), std::string::npos);
}

TEST(lines_analysis, rejects_an_end_that_leaps_at_the_beginning) {
  Description d = two_chains();
  d.lines[0].second.phase = 0.5 * std::numbers::pi;  // 2 m up at t = 0
  d.dynamics->build_up = 0.0;
  EXPECT_NE(rejection(d).find("jumps by 2 m"), std::string::npos) << rejection(d);
  EXPECT_NE(rejection(d).find("analysis.dynamic.build_up"), std::string::npos) << rejection(d);
}

TEST(lines_analysis, rejects_a_vessel_that_leaps_or_whose_record_ends_before_the_run) {
  Description d = two_chains();
  d.lines[0].second.kind = LineEndKind::body;
  d.vessel.motion = VesselMotion::harmonic;
  d.vessel.harmonic["heave"] = {1.0, 10.0, 0.5 * std::numbers::pi};
  d.dynamics->build_up = 0.0;
  EXPECT_NE(rejection(d).find("jumps by 1 m"), std::string::npos) << rejection(d);
  d.dynamics->build_up = 10.0;
  d.vessel.motion = VesselMotion::history;
  d.vessel.history.emplace();
  for (int i = 0; i <= 9; ++i) {  // of a run of 10 s
    d.vessel.history->time.push_back(i);
    d.vessel.history->freedoms.push_back({});
  }
  EXPECT_NE(rejection(d).find("does not cover the run"), std::string::npos) << rejection(d);
}

TEST(lines_analysis, rejects_a_vessel_that_no_line_holds_or_that_lies_on_mooring_lines) {
  Description d = two_chains();
  d.vessel.hydrostatics = HydrostaticsDescription{1e7, 1e9, 1e10};
  EXPECT_NE(rejection(d).find("nothing holds the free-floating vessel"), std::string::npos) << rejection(d);
  d.moorings.emplace().lines.emplace_back();
  EXPECT_NE(rejection(d).find("lines on a vessel with mooring lines"), std::string::npos) << rejection(d);
}

TEST(lines_analysis, warns_of_a_breaking_load_that_is_exceeded_in_time_alone) {
  Description d = two_chains();
  d.lines[0].segments[0].type.breaking_load = 1.05e6;  // 1,002 kN at rest, some 1,100 kN in time
  const auto lines = prepared(d);
  EXPECT_LT(*lines->statics.lines[0].utilisation, 1.0);
  const DynamicResults run = in_time(*lines);
  EXPECT_TRUE(has_finding(run.findings, "line \"west\": its largest tension of the run is 1.0"));
  EXPECT_FALSE(has_finding(run.findings, "compression"));
}

/// Two chains in a sea, with a short run.
Description chains_in_waves() {
  Description d = two_chains();
  d.environment.waves.front().type = WaveType::jonswap;
  d.environment.waves.front().hs = 2.0;
  d.environment.waves.front().tp = 8.0;
  d.environment.waves.front().components = 20;
  d.dynamics->duration = 4.0;
  d.dynamics->build_up = 2.0;
  return d;
}

TEST(lines_analysis, warns_of_a_sea_that_the_vessels_raos_do_not_reach) {
  const testing::TemporaryFolder folder;
  Description d = chains_in_waves();
  d.lines[0].second.kind = LineEndKind::body;
  d.vessel.motion = VesselMotion::raos;
  d.vessel.raos.emplace();
  d.vessel.raos->omegas = {0.1, 0.3};
  d.vessel.raos->headings = {0.0, std::numbers::pi};
  d.vessel.raos->values.assign(2 * 2 * 6, 0.0);
  const RealisationResult end = run_in(folder.path(), *prepared(d));
  ASSERT_EQ(end.ending, RunStatus::done) << end.why;
  EXPECT_TRUE(has_finding(end.results->findings, "lies above the highest frequency of the RAOs"));
}

TEST(lines_analysis, stopped_and_taken_up_again_gives_the_same_bits) {
  const testing::TemporaryFolder folder;
  const auto lines = prepared(chains_in_waves());
  const RealisationResult whole = run_in(folder / "whole", *lines);
  ASSERT_EQ(whole.ending, RunStatus::done) << whole.why;
  const auto stop = [](const DynamicProgress& dynamic_progress) {
    return dynamic_progress.time >= 1.0 ? DynamicControl::stop : DynamicControl::go_on;
  };
  EXPECT_EQ(run_in(folder / "parts", *lines, false, stop).ending, RunStatus::interrupted);
  EXPECT_TRUE(RunStore::find(folder / "parts"));
  double first = 1e9;
  const RealisationResult rest = run_in(folder / "parts", *lines, true, [&](const DynamicProgress& dynamic_progress) {
    first = std::min(first, dynamic_progress.time);
    return DynamicControl::go_on;
  });
  ASSERT_EQ(rest.ending, RunStatus::done) << rest.why;
  EXPECT_GT(first, 1.0);
  EXPECT_EQ(seed_values(lines->statics, *rest.results), seed_values(lines->statics, *whole.results));
  EXPECT_EQ(rest.results->energy.error, whole.results->energy.error);
  EXPECT_EQ(rest.results->run.steps, whole.results->run.steps);
  const auto history = [&](const char* name) {
    return Hdf5Reader(folder / name / "results.h5").doubles("/lines/0/second_tension");
  };
  EXPECT_EQ(history("parts"), history("whole"));
  EXPECT_FALSE(RunStore::find(folder / "parts"));
}

TEST(lines_analysis, a_run_of_another_model_is_not_taken_up) {
  const testing::TemporaryFolder folder;
  Description d = chains_in_waves();
  const auto stop = [](const DynamicProgress&) { return DynamicControl::stop; };
  EXPECT_EQ(run_in(folder.path(), *prepared(d), false, stop).ending, RunStatus::interrupted);
  d.source_text = "another";
  EXPECT_EQ(run_in(folder.path(), *prepared(d), true).ending, RunStatus::wrong_input);
}

TEST(lines_analysis, seeds_are_gathered_by_the_ends_of_every_line) {
  const auto lines = prepared(two_chains());
  const std::vector<SeedQuantity> quantities = seed_quantities(lines->statics);
  ASSERT_EQ(quantities.size(), 11U);  // five of each line, and the energy's drift
  EXPECT_EQ(quantities[2].name, "west/second_tension_max");
  EXPECT_EQ(quantities[9].name, "east/least_tension");
  const DynamicResults run = in_time(*lines);
  const std::vector<double> values = seed_values(lines->statics, run);
  EXPECT_EQ(values.at(2), run.lines[0].second_tension.max);
  EXPECT_EQ(values.at(9), run.lines[1].min_tension);
}

}  // namespace
}  // namespace overbend
