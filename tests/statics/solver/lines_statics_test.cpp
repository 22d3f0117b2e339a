/// Lines between two ends at rest, against the elastic catenary and other programs.
#include "statics/solver/lines_statics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "statics/moored/moored_lay.h"
#include "support/line_cases.h"

namespace overbend {
namespace {

using testing::RestingLines;

/// 64 mm wire, 92 m up and `across` away, wholly under water.
Description wire(double across, std::optional<double> element = {}) {
  Description d = testing::water_alone(1025.0, 100.0);
  LineTypeDescription type = testing::cable_type(16.3418, 0.0512, 165.48e6, 2e3, 1025.0);
  d.lines = {testing::free_line(type, 1007.339, Vec3(0.0, 0.0, -100.0), Vec3(across, 0.0, -8.0))};
  d.lines[0].element = element;
  return d;
}

struct PullRow {
  double across, horizontal, tension;  ///< [m], [kN]
};

// Horizontal force and tension of the elastic catenary (Jonkman 2007) at these spans.
const PullRow kPullCurve[] = {{990.0, 72.49, 85.32},
                              {998.0, 209.70, 222.53},
                              {1000.0, 287.17, 299.99},
                              {1002.0, 395.70, 408.51},
                              {1006.0, 721.72, 734.51}};

TEST(lines_statics, wire_on_the_bed_pulls_like_the_elastic_catenary) {
  for (const PullRow& row : kPullCurve) {
    const RestingLines lines(wire(row.across));
    ASSERT_TRUE(lines.rest.converged());
    // The reference is given to 0.01 kN; 0.05 % is what the bed's stiffness makes of it.
    EXPECT_NEAR(1e-3 * lines.last[0].x(), row.horizontal, 5e-4 * row.horizontal + 0.01) << row.across;
    EXPECT_NEAR(1e-3 * lines.last[0].norm(), row.tension, 5e-4 * row.tension + 0.01) << row.across;
  }
}

TEST(lines_statics, stiffness_of_the_wire_is_that_of_the_catenary) {
  const double stiffness = (RestingLines(wire(1000.05)).last[0].x() - RestingLines(wire(999.95)).last[0].x()) / 0.1;
  EXPECT_NEAR(1e-3 * stiffness, 45.95, 0.002 * 45.95);
}

TEST(lines_statics, do_not_depend_on_the_mesh) {
  const RestingLines usual(wire(1000.0)), fine(wire(1000.0, 10.0));
  EXPECT_GE(usual.line().mesh.elements(), 20);
  EXPECT_LE(usual.line().mesh.elements(), 40);
  EXPECT_GE(fine.line().mesh.elements(), 100);
  EXPECT_NEAR(usual.last[0].x(), fine.last[0].x(), 3e-4 * fine.last[0].x());
  EXPECT_NEAR(usual.last[0].z(), fine.last[0].z(), 3e-4 * fine.last[0].z());
}

/// NREL/MoorPy:tests/test_catenary.py.
struct MoorPyRow {
  double across, up, length, EA, w, below, horizontal, vertical;
};

TEST(lines_statics, taut_and_suspended_lines_are_those_of_moorpy) {
  const MoorPyRow rows[] = {
      {400.0, 200.0, 500.0, 7.51e12, 200.0, 372.7, 43694.58098925, 77634.40064978},
      {246.22420940032947, 263.55766330843164, 360.62566262396927, 7e8, 3.08735, 1e3, 71116.8, 76680.6},
      {246.22420940032947, 263.55766330843164, 360.64566262396927, 7e8, 3.08735, 1e3, 46077.1, 49878.6}};
  for (const MoorPyRow& row : rows) {
    Description d = testing::water_alone(1025.0, 500.0 + row.up + row.below);
    LineTypeDescription type = testing::cable_type(row.w / kGravity, 0.0, row.EA, 1.0, 1025.0);
    type.diameter = 0.1;
    d.lines = {testing::free_line(type, row.length, Vec3(0.0, 0.0, -500.0 - row.up), Vec3(row.across, 0.0, -500.0))};
    const RestingLines lines(d);
    ASSERT_TRUE(lines.rest.converged()) << lines.rest.lines[0].residual;
    EXPECT_NEAR(lines.last[0].x(), row.horizontal, 2e-4 * row.horizontal);
    EXPECT_NEAR(lines.last[0].z(), row.vertical, 2e-4 * row.vertical);
  }
}

TEST(lines_statics, chains_of_moordyn_pull_like_their_closed_form) {
  const double rows[][3] = {{50.0, 1002.0, 835.9}, {200.0, 2070.8, 1406.6}, {600.0, 5237.9, 3248.3}};
  for (const auto& row : rows) {
    const RestingLines lines(testing::chain_case(row[0], 0.0));
    ASSERT_TRUE(lines.rest.converged());
    // The line is half in air at its very top: 0.05 %; its horizontal force is what the anchor sees.
    EXPECT_NEAR(1e-3 * lines.last[0].norm(), row[1], 2e-3 * row[1]) << row[0];
    EXPECT_NEAR(1e-3 * std::abs(lines.first[0].x()), row[2], 2e-3 * row[2]) << row[0];
  }
}

TEST(lines_statics, jumper_is_the_published_one) {
  const RestingLines lines(testing::jumper_case(Vec3::Zero()));
  ASSERT_TRUE(lines.rest.converged());
  // Given to 10 N.
  EXPECT_NEAR(1e-3 * lines.last[0].x(), 11.40, 0.02);
  EXPECT_NEAR(1e-3 * lines.last[0].z(), 45.71, 0.02);
  EXPECT_NEAR(1e-3 * lines.first[0].x(), -11.40, 0.02);
  EXPECT_NEAR(1e-3 * lines.first[0].z(), 24.04, 0.02);
}

TEST(lines_statics, ends_clumps_and_buoys_bear_one_another) {
  Description d = wire(990.0);
  d.environment.water_depth = 500.0;
  LinePointDescription clump, buoy;
  clump.net_force = -60e3;
  clump.at = 700.0;
  buoy.kind = PointKind::buoy;
  buoy.net_force = 40e3;
  buoy.mass = 1e3;
  buoy.at = 880.0;
  d.lines[0].points = {clump, buoy};
  d.lines[0].first.at.z() = -60.0;
  const RestingLines lines(d);
  ASSERT_TRUE(lines.rest.converged());
  const double weight = 1007.339 * d.lines[0].segments[0].type.weight_submerged + 60e3 - 40e3;
  EXPECT_NEAR(lines.first[0].z() + lines.last[0].z(), weight, 1e-6 * weight);
  EXPECT_NEAR(lines.first[0].x() + lines.last[0].x(), 0.0, 1e-3);
  for (const LinePoint& point : lines.line().points) {
    EXPECT_DOUBLE_EQ(lines.line().mesh.s[static_cast<std::size_t>(point.node)], point.buoyancy > 1.0 ? 880.0 : 700.0);
  }
}

TEST(lines_statics, a_buoy_that_turns_a_slack_line_leaves_it_the_tension_of_either_side) {
  const LineTypeDescription rope = testing::cable_type(40.0, 0.15, 2e8, 0.0, 1025.0);
  LineTypeDescription chain = rope;
  chain.axial_stiffness *= 10.0;
  for (const bool softer_first : {true, false}) {
    Description d = testing::water_alone(1025.0, 80.0);
    d.lines = {testing::free_line(rope, 60.0, Vec3(10.0, 5.0, -10.0), Vec3(150.0, -40.0, -80.0))};
    d.lines[0].segments.push_back(d.lines[0].segments[0]);
    d.lines[0].segments[1].length = 140.0;
    d.lines[0].segments[softer_first ? 1 : 0].type = chain;  // the joint is on the softer side
    LinePointDescription buoy;
    buoy.kind = PointKind::buoy;
    buoy.net_force = 30e3;
    buoy.at = 60.0;
    d.lines[0].points = {buoy};
    const LineResult line = solve_lines(build_model(d)).lines.at(0);
    // Level share of the pull, and what pulls down behind the buoy: what the top bears, less what hangs there, and 30
    // kN.
    const double level = std::hypot(line.first.force.x(), line.first.force.y());
    const double behind = line.first.force.z() - 60.0 * rope.weight_submerged + 30e3;
    EXPECT_NEAR(line.max_tension, std::hypot(level, behind), 0.01 * line.max_tension) << softer_first;
    EXPECT_GT(line.min_tension, 0.99 * level) << softer_first;  // nowhere less than its level share
  }
}

TEST(lines_statics, an_upright_line_with_a_little_slack_is_pulled_by_its_weight_alone) {
  for (const double slack : {0.05, 0.2}) {
    for (const double across : {0.0, 0.5}) {
      Description d = testing::water_alone(1025.0, 200.0);
      const LineTypeDescription hose = testing::cable_type(60.0, 0.2, 100e6, 5e3, 1025.0);
      d.lines = {testing::free_line(hose, 180.0 + slack, Vec3(0.0, 0.0, -5.0), Vec3(across, 0.0, -185.0))};
      const RestingLines lines(d);
      ASSERT_TRUE(lines.rest.converged());
      const double weight = (180.0 + slack) * hose.weight_submerged;
      // Bending and stretch at the lower end are a few per cent; folded elements pulled with thirty times the weight.
      EXPECT_NEAR(lines.first[0].z(), weight, 0.05 * weight) << slack << ", " << across;
    }
  }
}

/// More slack than elements can follow where the line turns back at its lower end.
TEST(lines_statics, an_upright_line_has_its_weight_or_is_reported_as_folded) {
  const LineTypeDescription hose = testing::cable_type(60.0, 0.2, 100e6, 5e3, 1025.0);
  for (const double slack : {0.5, 1.0, 2.0, 3.0}) {
    Description d = testing::water_alone(1025.0, 200.0);
    d.lines = {testing::free_line(hose, 180.0 + slack, Vec3(0.0, 0.0, -5.0), Vec3(0.0, 0.0, -185.0))};
    const ModelEquilibrium found = solve_lines(build_model(d));
    ASSERT_FALSE(found.failure) << slack;
    const double weight = (180.0 + slack) * hose.weight_submerged;
    const bool right = std::abs(found.lines.front().first.tension - weight) < 0.1 * weight;
    const bool reported = std::ranges::any_of(messages(found.findings), [](const std::string& warning) {
      return warning.find("an element is folded") != std::string::npos;
    });
    EXPECT_TRUE(right || reported) << slack << ": " << found.lines.front().first.tension;
  }
}

TEST(lines_statics, segments_differ_where_they_meet) {
  Description d = wire(990.0);
  d.environment.water_depth = 500.0;
  LineTypeDescription chain = testing::cable_type(100.0, 0.13, 5e8, 2e3, 1025.0);
  d.lines[0].segments = {{"chain", 300.0, chain}, {"wire", 707.339, d.lines[0].segments[0].type}};
  d.lines[0].first.at.z() = -60.0;
  const RestingLines lines(d);
  ASSERT_TRUE(lines.rest.converged());
  const double weight = 300.0 * chain.weight_submerged + 707.339 * d.lines[0].segments[1].type.weight_submerged;
  const Line& line = lines.line();
  EXPECT_EQ(std::count(line.mesh.s.begin(), line.mesh.s.end(), 300.0), 1);
  EXPECT_NEAR(lines.first[0].z() + lines.last[0].z(), weight, 1e-6 * weight);
  EXPECT_DOUBLE_EQ(line.elements.EA[0], 5e8);
  EXPECT_DOUBLE_EQ(line.elements.EA[static_cast<std::size_t>(line.mesh.elements() - 1)], 165.48e6);
}

TEST(lines_statics, slack_lying_suspended_and_rising_lines_reach_equilibrium) {
  struct Case {
    const char* name;
    Vec3 first, second;
    double length, volume_diameter;
  };
  const Case cases[] = {{"slack, the rest on the bed", {0.0, 0.0, -100.0}, {300.0, 0.0, -8.0}, 420.0, 0.05},
                        {"lying", {0.0, 0.0, -100.0}, {400.0, 100.0, -100.0}, 412.0, 0.05},
                        {"lying, slack", {0.0, 0.0, -100.0}, {400.0, 100.0, -100.0}, 440.0, 0.05},
                        {"straight down", {0.0, 0.0, -60.0}, {0.0, 0.0, -8.0}, 51.99, 0.05},
                        {"a narrow bight", {0.0, 0.0, -20.0}, {5.0, 0.0, -8.0}, 120.0, 0.05},
                        {"taut", {0.0, 0.0, -100.0}, {300.0, 40.0, -8.0}, 314.0, 0.05},
                        {"rising from both ends", {0.0, 0.0, -90.0}, {200.0, 0.0, -90.0}, 230.0, 0.17},
                        {"a bight on the bed", {0.0, 0.0, -8.0}, {300.0, 0.0, -20.0}, 420.0, 0.05},
                        {"a bight afloat", {0.0, 0.0, -10.0}, {200.0, 0.0, -10.0}, 320.0, 0.17},
                        {"steep and slack", {0.0, 0.0, -100.0}, {2.0, 0.0, -5.0}, 160.0, 0.05},
                        {"steep, slack and afloat", {0.0, 0.0, -100.0}, {2.0, 0.0, 0.0}, 150.0, 0.17}};
  for (const Case& single : cases) {
    Description d = testing::water_alone(1025.0, 100.0);
    d.environment.seabed.friction_axial = d.environment.seabed.friction_lateral = 0.6;
    LineTypeDescription type = testing::cable_type(16.3418, single.volume_diameter, 165.48e6, 2e3, 1025.0);
    d.lines = {testing::free_line(type, single.length, single.first, single.second)};
    const RestingLines lines(d);
    EXPECT_TRUE(lines.rest.converged()) << single.name << ": " << lines.rest.lines[0].residual << " after "
                                        << lines.rest.lines[0].iterations;
  }
}

TEST(lines_statics, current_pulls_a_line_with_its_drag) {
  Description d = wire(990.0);
  d.environment.water_depth = 500.0;
  d.lines[0].first.at.z() = -60.0;
  d.environment.current = {{0.0, 1.0, 0.0}, {100.0, 1.0, 0.0}};  // to the north, across the line
  const RestingLines lines(d);
  ASSERT_TRUE(lines.rest.converged());
  const Line& line = lines.line();
  const double drag = line.elements.drag_normal[0] * 1007.339;
  EXPECT_NEAR(lines.first[0].y() + lines.last[0].y(), -drag, 0.03 * drag);
}

}  // namespace
}  // namespace overbend
