#include "recording/mooring_recorder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "checks/run_checks.h"
#include "modelfile/reading/yaml_reader.h"
#include "recording/run_dynamics.h"
#include "resultfiles/summary/summary_json.h"
#include "study/run/static_analysis.h"
#include "support/memory_sink.h"

namespace overbend {
namespace {

/// A second of the BGL-1 on its moorings.
struct Second {
  StaticResults statics;
  DynamicResults results;
  testing::MemorySink sink;
};

Description moored_bgl1() {
  Description d = read_model(OVERBEND_SOURCE_DIR "/examples/bgl1-moored.yaml").description.value();
  d.environment.waves.front().components = 40;
  d.mesh.overbend_element = 1.0;
  d.mesh.touchdown_element = 3.0;
  d.mesh.max_element_length = 8.0;
  d.dynamics = DynamicSettings{};
  d.dynamics->duration = 0.5;
  d.statics.mean_drift = false;  // tensions of statics and of the run are compared
  d.dynamics->build_up = 0.5;
  return d;
}

Second run_one_second(const Description& d) {
  Model model = build_model(d);
  const ModelEquilibrium lay = solve_lay(model);
  Second second;
  second.statics = checked_statics(model, lay);
  const DynamicOutcome outcome = run_dynamics(model, *lay.solution, second.statics, dynamic_options(model), second.sink,
                                              nullptr, [](const DynamicProgress&) { return DynamicControl::go_on; });
  second.results = outcome.results.value();
  return second;
}

Second second_with(const std::function<void(MooringsDescription&)>& change) {
  Description d = moored_bgl1();
  change(*d.moorings);
  return run_one_second(d);
}

/// Run once for all that look at it.
const Second& usual() {
  static const Second kSecond = second_with([](MooringsDescription&) {});
  return kSecond;
}

bool says(const Findings& findings, const std::string& message) {
  return std::ranges::any_of(findings, [&](const Finding& finding) {
    return finding.object == "mooring line port bow" && finding.message.find(message) != std::string::npos;
  });
}

// The line has some 320 kN.
TEST(mooring_watch, says_which_line_is_beyond_what_it_bears) {
  const Findings weak = second_with([](MooringsDescription& moorings) {
                          MooringLineDescription& line = moorings.lines.front();
                          line.segments.front().type.breaking_load = 250e3;
                          line.anchor_holding.holding = 200e3;
                        }).results.findings;
  EXPECT_TRUE(says(weak, "its breaking load of 250.0 kN"));
  EXPECT_TRUE(says(weak, "holding power"));
}

// The current acts on lines of elements, which have 3 % more or less for it than the catenaries of statics.
TEST(mooring_watch, begins_with_the_tensions_of_statics_where_there_is_no_current) {
  Description d = moored_bgl1();
  d.environment.current.clear();
  const Second second = run_one_second(d);
  for (std::size_t i = 0; i < second.results.moorings.size(); ++i) {
    const double at_rest = second.statics.moorings->rest.moorings[i].fairlead_tension;
    EXPECT_NEAR(second.results.moorings[i].start_fairlead_tension, at_rest, 0.003 * at_rest) << i;
  }
}

TEST(mooring_watch, reports_for_lines_what_statics_reports_while_little_moves) {
  const Second& second = usual();
  EXPECT_FALSE(says(second.results.findings, "kN"));
  const std::vector<MooringLineResult>& rest = second.statics.moorings->rest.moorings;
  const std::vector<MooringLineDynamics>& lines = second.results.moorings;
  ASSERT_EQ(lines.size(), 8U);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    EXPECT_EQ(lines[i].name, rest[i].name);
    // The run's first row has it from the line itself; statics from a catenary, and its hull lies a little elsewhere.
    EXPECT_EQ(lines[i].start_fairlead_tension, second.sink.column("mooring/" + lines[i].name + "/fairlead_tension")[0]);
    EXPECT_NEAR(lines[i].start_fairlead_tension, rest[i].fairlead_tension, 0.05 * rest[i].fairlead_tension);
    EXPECT_NEAR(lines[i].fairlead_tension.whole.mean, rest[i].fairlead_tension, 0.05 * rest[i].fairlead_tension);
    EXPECT_NEAR(lines[i].min_on_seabed, rest[i].on_bed, 60.0);  // as the nodes stand
    EXPECT_NEAR(lines[i].length.mean, rest[i].length, 1e-6 * rest[i].length);
    EXPECT_EQ(lines[i].max_uplift, 0.0);
    EXPECT_EQ(lines[i].time_slack, 0.0);
  }
  const double breaking = rest[0].fairlead_tension / *rest[0].utilisation;
  EXPECT_NEAR(*lines[0].utilisation, lines[0].fairlead_tension.whole.max / breaking, 1e-12);
  EXPECT_FALSE(lines[0].parted_at);
}

TEST(mooring_watch, films_the_lines_from_anchor_to_fairlead) {
  const Second& second = usual();
  ASSERT_FALSE(second.sink.snapshots.empty());
  std::size_t points = 0;
  for (const MooringLineDynamics& line : second.results.moorings) points += line.points.size();
  const std::vector<double>& last = second.sink.snapshots.back();
  ASSERT_EQ(last.size(), 5 * second.results.station_s.size() + 12 + 4 * points);
  const double* node_dofs = last.data() + last.size() - 4 * points;
  const std::vector<MooringLineResult>& rest = second.statics.moorings->rest.moorings;
  for (std::size_t i = 0; i < rest.size(); ++i) {
    const std::vector<double>& shares = second.results.moorings[i].points;
    EXPECT_EQ(shares.front(), 0.0);
    EXPECT_EQ(shares.back(), 1.0);
    EXPECT_NEAR((Vec3(node_dofs[0], node_dofs[1], node_dofs[2]) - rest[i].anchor_W).norm(), 0.0, 1e-6);
    node_dofs += 4 * shares.size();
    EXPECT_NEAR((Vec3(node_dofs[-4], node_dofs[-3], node_dofs[-2]) - rest[i].fairlead_W).norm(), 0.0,
                0.5);  // the hull moves a little
    EXPECT_NEAR(node_dofs[-1], rest[i].fairlead_tension, 0.05 * rest[i].fairlead_tension);
  }
}

TEST(mooring_watch, histories_report_where_the_vessel_is_from_the_drawn_place) {
  const Second& second = usual();
  const VesselResult& rest = second.statics.moorings->rest.vessel;
  const std::vector<double> shift = second.sink.column("vessel/sway"), roll = second.sink.column("vessel/roll"),
                            from_rest = second.sink.column("sway");
  ASSERT_FALSE(shift.empty());
  constexpr double kHeight = 0.818;  // of the centre of gravity, which the other history is of
  for (std::size_t i = 0; i < shift.size(); ++i) {
    EXPECT_NEAR(shift[i], rest.sway + from_rest[i] + kHeight * roll[i], 1e-3) << i;
  }
  ASSERT_TRUE(second.results.vessel);
  EXPECT_EQ(second.results.vessel->start_sway, shift.front());
  EXPECT_EQ(second.sink.column("vessel/offset").front(), 0.0);
}

TEST(mooring_watch, reports_when_a_line_parts) {
  const Second second = second_with([](MooringsDescription& moorings) { moorings.lines[2].fails_at = 0.4; });
  const MooringLineDynamics &gone = second.results.moorings[2], &intact = second.results.moorings[3];
  ASSERT_TRUE(gone.parted_at);
  EXPECT_NEAR(*gone.parted_at, 0.4, 0.05);  // the first step that ends without it
  ASSERT_EQ(gone.events.size(), 1U);
  EXPECT_EQ(gone.events.front().what, "parted");
  EXPECT_NEAR(second.sink.column("mooring/" + gone.name + "/fairlead_tension").back(), 0.0, 1.0);
  EXPECT_FALSE(intact.parted_at);
  EXPECT_TRUE(intact.events.empty());
  EXPECT_EQ(gone.intact_fairlead_tension, gone.fairlead_tension.whole.max);  // it has none after it has parted
}

// Two seconds, in which waves pull some lines more than they did before the other parted.
TEST(mooring_watch, keeps_the_largest_tensions_of_the_time_in_which_every_line_holds) {
  Description d = moored_bgl1();
  d.dynamics->duration = 2.0;
  d.moorings->lines[2].fails_at = 0.4;
  const Second whole = run_one_second(d);
  int grown = 0;
  for (std::size_t i = 0; i < whole.results.moorings.size(); ++i) {
    const MooringLineDynamics& line = whole.results.moorings[i];
    const SummaryStatistics& held =
        usual().results.moorings[i].fairlead_tension.whole;  // of half a second without a failure
    EXPECT_LE(line.intact_fairlead_tension, held.max * (1.0 + 1e-6)) << line.name;
    EXPECT_GT(line.intact_fairlead_tension, held.min * (1.0 - 1e-6)) << line.name;
    if (line.fairlead_tension.whole.max > line.intact_fairlead_tension) ++grown;
  }
  EXPECT_GT(grown, 0);
}

// Some lines have a little more than the brake holds: it lets out until it holds them.
TEST(mooring_watch, reports_what_a_brake_lets_out) {
  const Second second = second_with([](MooringsDescription& moorings) { moorings.winches.front().brake = 375e3; });
  double changed = 0.0;
  for (std::size_t i = 0; i < 8; ++i) {
    const MooringLineDynamics& line = second.results.moorings[i];
    const double before = second.statics.moorings->rest.moorings[i].length;
    EXPECT_NEAR(line.length.max, before + line.brake_rendered, 1e-6 * before) << line.name;
    EXPECT_LT(line.fairlead_tension.whole.max, 1.01 * 375e3) << line.name;
    changed += line.brake_rendered;
  }
  EXPECT_GT(changed, 1e-3);
  EXPECT_TRUE(std::ranges::any_of(messages(second.results.findings), [](const auto& warning) {
    return warning.find("its brake, set to 375.0 kN, slipped by") != std::string::npos;
  }));
}

/// Catenaries follow lengths for any tension.
TEST(mooring_watch, says_that_a_brake_of_quasi_static_lines_would_have_rendered) {
  const Second second = second_with([](MooringsDescription& moorings) {
    moorings.model = MooringModel::quasi_static;
    moorings.winches.front().brake = 100e3;
  });
  EXPECT_TRUE(
      says(second.results.findings, "more than its winch's brake (quasi-static lines: not rendered) of 100.0 kN"));
}

TEST(mooring_watch, says_at_which_tension_a_winch_without_a_stall_of_its_own_hauls_no_more) {
  const Second second = second_with([](MooringsDescription& moorings) {
    for (WinchDescription& winch : moorings.winches) {
      winch.mode = WinchMode::speed;
      winch.program = {{0.0, -1.0}};
      winch.stall.reset();
      winch.haul = 60e3;  // less than any line bears
    }
  });
  EXPECT_TRUE(says(second.results.findings, "it stalls at 60.0 kN"));
}

TEST(mooring_watch, says_that_a_long_way_of_a_winch_makes_a_long_element) {
  const Second second = second_with([](MooringsDescription& moorings) {
    WinchDescription& winch = moorings.winches.front();
    winch.mode = WinchMode::length;
    winch.program = {{100.0, 0.0}, {400.0, 60.0}};
  });
  EXPECT_TRUE(says(second.results.findings, "its shape and tension are less accurate"));
  EXPECT_FALSE(says(usual().results.findings, "its shape and tension are less accurate"));
}

TEST(mooring_watch, a_resumed_run_reports_the_same_bits) {
  Description d = moored_bgl1();
  d.dynamics->duration = 0.375;
  d.dynamics->output_step = 0.125;
  d.moorings->lines[0].fails_at = 0.24;
  Model model = build_model(d);
  const ModelEquilibrium lay = solve_lay(model);
  const StaticResults statics = checked_statics(model, lay);
  const auto run = [&](testing::MemorySink& sink, const DynamicCheckpoint* from, double checkpoint_at) {
    const auto control = [&](const DynamicProgress& dynamic_progress) {
      return std::abs(dynamic_progress.time - checkpoint_at) < 1e-6 ? DynamicControl::checkpoint
                                                                    : DynamicControl::go_on;
    };
    return run_dynamics(model, *lay.solution, statics, dynamic_options(model), sink, from, control).results.value();
  };
  testing::MemorySink whole, rest;
  const DynamicResults first = run(whole, nullptr, 0.25);
  ASSERT_EQ(whole.checkpoints.size(), 1U);
  const DynamicResults second = run(rest, &whole.checkpoints.front(), 99.0);
  Json wanted, found;
  add_moored_dynamics(first, wanted);
  add_moored_dynamics(second, found);
  EXPECT_TRUE(first.moorings[0].parted_at);
  EXPECT_EQ(found, wanted);
  EXPECT_EQ(rest.snapshots.back(), whole.snapshots.back());
}

}  // namespace
}  // namespace overbend
