#include "recording/mooring_watch.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "checks/run_checks.h"
#include "modelfile/yaml_reader.h"
#include "recording/run_dynamics.h"
#include "study/static_run.h"
#include "support/memory_sink.h"

namespace overbend {
namespace {

/// A second of the BGL-1 on its moorings.
struct Second {
  StaticResults statics;
  DynamicResults results;
  testing::MemorySink sink;
};

Second second_with(double breaking, double brake, double holding) {
  Description d = read_model(OVERBEND_SOURCE_DIR "/examples/bgl1-moored.yaml").description.value();
  d.environment.waves.components = 40;
  d.mesh.overbend_element = 1.0;
  d.mesh.touchdown_element = 3.0;
  d.mesh.longest_element = 8.0;
  d.dynamics = DynamicSettings{};
  d.dynamics->duration = 0.5;
  d.dynamics->build_up = 0.5;
  MooringLineDescription& line = d.moorings->lines.front();
  line.segments.front().type.breaking_load = breaking;
  line.anchor_holding.holding = holding;
  d.moorings->winches.front().brake = brake;
  Model model = build_model(d);
  const LayOutcome lay = solve_lay(model);
  Second second;
  second.statics = checked_statics(model, lay);
  const DynamicOutcome outcome = run_dynamics(model, *lay.solution, second.statics, dynamic_options(model), second.sink,
                                              nullptr, [](const DynamicProgress&) { return DynamicControl::go_on; });
  second.results = outcome.results.value();
  return second;
}

/// Run once for all that look at it.
const Second& usual() {
  static const Second kSecond = second_with(2594e3, 1600e3, 1500e3);
  return kSecond;
}

bool says(const std::vector<std::string>& warnings, const std::string& words) {
  return std::any_of(warnings.begin(), warnings.end(), [&](const std::string& warning) {
    return warning.find("\"port bow\"") != std::string::npos && warning.find(words) != std::string::npos;
  });
}

// The line has some 320 kN.
TEST(mooring_watch, says_which_line_is_beyond_what_it_bears) {
  const std::vector<std::string> weak = second_with(250e3, 260e3, 200e3).results.warnings;
  EXPECT_TRUE(says(weak, "its breaking load of 250.0 kN"));
  EXPECT_TRUE(says(weak, "brake"));
  EXPECT_TRUE(says(weak, "holding power"));
}

TEST(mooring_watch, tells_of_lines_what_statics_tells_while_little_moves) {
  const Second& second = usual();
  EXPECT_FALSE(says(second.results.warnings, "kN"));
  const std::vector<MooringLineResult>& rest = second.statics.moorings->rest.moorings;
  const std::vector<MooringLineDynamics>& lines = second.results.moorings;
  ASSERT_EQ(lines.size(), 8U);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    EXPECT_EQ(lines[i].name, rest[i].name);
    // The run's first row has it from the line itself; statics from a catenary, and its hull lies a little elsewhere.
    EXPECT_EQ(lines[i].start_fairlead_tension, second.sink.column("mooring/" + lines[i].name + "/fairlead_tension")[0]);
    EXPECT_NEAR(lines[i].start_fairlead_tension, rest[i].fairlead_tension, 0.05 * rest[i].fairlead_tension);
    EXPECT_NEAR(lines[i].fairlead_tension.whole.mean, rest[i].fairlead_tension, 0.05 * rest[i].fairlead_tension);
    EXPECT_NEAR(lines[i].least_on_bed, rest[i].on_bed, 60.0);  // as the nodes stand
    EXPECT_NEAR(lines[i].length.mean, rest[i].length, 1e-6 * rest[i].length);
    EXPECT_EQ(lines[i].largest_uplift, 0.0);
    EXPECT_EQ(lines[i].time_slack, 0.0);
  }
  EXPECT_NEAR(*lines[0].utilisation, lines[0].fairlead_tension.whole.max / 2594e3, 1e-12);
  EXPECT_FALSE(lines[0].parted_at);
}

TEST(mooring_watch, films_the_lines_from_anchor_to_fairlead) {
  const Second& second = usual();
  ASSERT_FALSE(second.sink.snapshots.empty());
  std::size_t points = 0;
  for (const MooringLineDynamics& line : second.results.moorings) points += line.points.size();
  const std::vector<double>& last = second.sink.snapshots.back();
  ASSERT_EQ(last.size(), 5 * second.results.station_s.size() + 12 + 4 * points);
  const double* at = last.data() + last.size() - 4 * points;
  const std::vector<MooringLineResult>& rest = second.statics.moorings->rest.moorings;
  for (std::size_t i = 0; i < rest.size(); ++i) {
    const std::vector<double>& shares = second.results.moorings[i].points;
    EXPECT_EQ(shares.front(), 0.0);
    EXPECT_EQ(shares.back(), 1.0);
    EXPECT_NEAR((Vec3(at[0], at[1], at[2]) - rest[i].anchor_W).norm(), 0.0, 1e-6);
    at += 4 * shares.size();
    EXPECT_NEAR((Vec3(at[-4], at[-3], at[-2]) - rest[i].fairlead_W).norm(), 0.0, 0.5);  // the hull moves a little
    EXPECT_NEAR(at[-1], rest[i].fairlead_tension, 0.05 * rest[i].fairlead_tension);
  }
}

TEST(mooring_watch, histories_tell_where_the_vessel_is_from_the_drawn_place) {
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

}  // namespace
}  // namespace overbend
