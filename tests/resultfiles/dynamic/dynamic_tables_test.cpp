#include <gtest/gtest.h>

#include "resultfiles/dynamic/dynamic_writer.h"
#include "resultfiles/static/results_writer.h"
#include "support/csv_text.h"
#include "support/dynamic_case.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

using testing::csv_cells;
using testing::csv_lines;
using testing::filled_dynamics;
using testing::solved_case;
using testing::value_in;

/// Each line of `longer` begins with that of `text`.
void expect_begins_with(const std::string& longer, const std::string& text) {
  const std::vector<std::string> a = csv_lines(longer), b = csv_lines(text);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].substr(0, b[i].size() + 1), b[i] + ",");
    EXPECT_EQ(csv_cells(a[i]).size(), csv_cells(a[0]).size());
  }
}

TEST(dynamic_tables, begin_as_those_of_statics) {
  const StaticResults& statics = solved_case("BGL1-T250").results;
  const DynamicResults dynamics = filled_dynamics(statics);
  expect_begins_with(dynamic_pipe_table(statics, dynamics), pipe_table(statics));
  expect_begins_with(dynamic_supports_table(statics, dynamics), supports_table(statics));
}

TEST(dynamic_pipe_table, takes_the_envelopes_between_two_stations_in_proportion) {
  const StaticResults& statics = solved_case("BGL1-T250").results;
  DynamicResults dynamics = filled_dynamics(statics);
  const double length = statics.total_length;
  // Bends at 0.4 of the length; beyond the last station the last value holds.
  dynamics.station_s = {0.0, 0.4 * length, 0.9 * length};
  const auto kinked = [&](double low, double high) { return std::vector<double>{low, high, low}; };
  for (Envelope* e : {&dynamics.effective_tension, &dynamics.bending_moment, &dynamics.bending_stress,
                      &dynamics.von_mises, &dynamics.strain}) {
    *e = {kinked(0.0, 1e6), kinked(1e6, 4e6), kinked(3e6, 2e6), kinked(0.0, 8e6)};
  }
  const std::vector<std::string> lines = csv_lines(dynamic_pipe_table(statics, dynamics));
  for (std::size_t i = 0; i < statics.stations.size(); i += 17) {
    const double share = statics.stations[i].s / length;
    const double rise = std::max(0.0, share < 0.4 ? share / 0.4 : (0.9 - share) / 0.5);
    // Twelve digits are written.
    EXPECT_NEAR(value_in(lines, i + 1, "tension min [kN]"), 1e3 * rise, 1e-8);
    EXPECT_NEAR(value_in(lines, i + 1, "bending moment max [kN m]"), 1e3 + 3e3 * rise, 1e-8);
    EXPECT_NEAR(value_in(lines, i + 1, "von Mises stress mean [MPa]"), 3.0 - rise, 1e-11);
    EXPECT_NEAR(value_in(lines, i + 1, "bending stress std [MPa]"), 8.0 * rise, 1e-11);
    EXPECT_NEAR(value_in(lines, i + 1, "strain max [%]"), 1e8 + 3e8 * rise, 1e-3);
  }
}

TEST(dynamic_supports_table, gives_each_roller_its_own) {
  const StaticResults& statics = solved_case("BGL1-T250").results;
  DynamicResults dynamics = filled_dynamics(statics);
  const std::vector<std::string> lines = csv_lines(dynamic_supports_table(statics, dynamics));
  ASSERT_EQ(lines.size(), 14U);
  for (std::size_t i = 0; i < 13; ++i) {
    const RollerDynamics& roller = dynamics.supports[i].rollers[0];
    const auto near = [](double value) { return 1e-11 * std::abs(value); };
    EXPECT_NEAR(value_in(lines, i + 1, "reaction normal max [kN]"), roller.reaction.max / 1e3, near(1));
    EXPECT_NEAR(value_in(lines, i + 1, "separation std [m]"), roller.separation.std, near(roller.separation.std));
    EXPECT_NEAR(value_in(lines, i + 1, "contact share [-]"), roller.contact_share, near(roller.contact_share));
    EXPECT_EQ(value_in(lines, i + 1, "impacts"), static_cast<double>(roller.impact_count));
    EXPECT_NEAR(value_in(lines, i + 1, "largest impulse [kN s]"), roller.max_impulse / 1e3, near(1));
    EXPECT_NEAR(value_in(lines, i + 1, "dent depth [mm]"), roller.dent_depth * 1e3, near(roller.dent_depth * 1e3));
  }
  dynamics.supports[4].rollers.clear();
  EXPECT_THROW(dynamic_supports_table(statics, dynamics), std::runtime_error);
}

TEST(impacts_table, names_the_roller_that_was_hit) {
  const StaticResults& statics = solved_case("BGL1-T250").results;
  DynamicResults dynamics = filled_dynamics(statics);
  dynamics.hardest_impacts = {{12, 3.5, 0.25, 2e5, 0.02, 900.0, 1e-3, 2e6}, {99, 1.0, 0.1, 1e5, 0.1, 9.0, 0.0, 0.0}};
  const std::vector<std::string> lines = csv_lines(impacts_table(dynamics));
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[1], statics.supports[12].name + ",1,bottom,3.5,0.25,200,0.02,0.9,1,2000");
  EXPECT_EQ(lines[2], ",,,1,0.1,100,0.1,0.009,0,0");
}

TEST(impacts_table, has_its_head_alone_in_j_lay) {
  EXPECT_EQ(csv_lines(impacts_table(filled_dynamics(solved_case("J12-D400-T560").results))).size(), 1U);
}

TEST(dynamic_supports_table, leaves_the_cells_of_an_absent_separation_empty) {
  const StaticResults& statics = solved_case("BGL1-T250").results;
  DynamicResults dynamics = filled_dynamics(statics);
  const double absent = std::numeric_limits<double>::quiet_NaN();
  dynamics.supports[0].rollers[0].separation = {absent, absent, absent, absent};
  const std::string table = dynamic_supports_table(statics, dynamics);
  EXPECT_NE(table.find(",,,,"), std::string::npos);
  EXPECT_EQ(table.find("nan"), std::string::npos);
}

}  // namespace
}  // namespace overbend
