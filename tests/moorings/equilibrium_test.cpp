#include "moorings/equilibrium.h"

#include <gtest/gtest.h>

#include <chrono>

#include "moorings/bgl1_spread.h"

namespace overbend {
namespace {

using Case = MooredCase;

Case make_mooring_case(const Description& d) {
  return moored_case(d);
}

void expect_line(const Json& want, const MooringSpread& spread, const HullEquilibrium& rest, std::size_t i) {
  ASSERT_EQ(want["name"], spread.lines[i].name);
  const CatenarySolution& found = rest.lines[i];
  const double tension = want["fairlead_tension"];
  EXPECT_NEAR(found.tension(), tension, 1e-6 * tension);
  EXPECT_NEAR(found.pull, want["horizontal"], 1e-6 * tension);
  EXPECT_NEAR(std::atan2(found.sink, found.pull), want["declination"], 1e-6);
  EXPECT_NEAR(found.anchor_tension(), want["anchor_tension"], 1e-6 * tension);
  EXPECT_NEAR(found.trace.touchdown_s, want["suspended_length"], 1e-4);
  EXPECT_NEAR(found.trace.touchdown_x, want["touchdown_distance"], 1e-4);
  EXPECT_NEAR(found.trace.on_bed, want["length_on_bed"], 1e-4);
  EXPECT_NEAR(spread.lines[i].line.first_segment(), want["first_segment_length"], 1e-5);
}

void expect_vessel(const Json& want, const HullOffset& offset) {
  const char* modes[] = {"surge", "sway", "heave", "roll", "pitch", "yaw"};
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(offset[i], want[modes[i]], i < 3 ? 1e-5 : 1e-7) << modes[i];
}

void expect_stage(const Json& want, const MooringSpread& spread, const HullEquilibrium& rest) {
  expect_vessel(want["vessel"], rest.offset);
  for (std::size_t i = 0; i < spread.lines.size(); ++i) expect_line(want["moorings"][i], spread, rest, i);
  if (want.contains("mooring_force")) {
    for (int i = 0; i < 6; ++i) EXPECT_NEAR(rest.forces.moorings[i], want["mooring_force"][i], i < 3 ? 0.5 : 50.0) << i;
  }
  if (!want.contains("mooring_stiffness")) return;
  for (int i = 0; i < 6; ++i) {
    for (int k = 0; k < 6; ++k) {
      // Their stiffness is by differences, good to 1e-6 of the largest of its kind.
      const double scale = (i < 3 ? 2e5 : 2e5 * 60.0) * (k < 3 ? 1.0 : 60.0);
      EXPECT_NEAR(rest.forces.mooring_stiffness(i, k), want["mooring_stiffness"][i][k], 1e-6 * scale) << i << k;
    }
  }
}

TEST(mooring_statics, wires_of_a_held_hull_are_those_of_the_collocation) {
  Description d = reference_barge();
  const Json expected = expected_case("MO1-wire")["static"]["moorings"];
  auto& lines = d.moorings->lines;
  lines.push_back(mooring_line("A", {58, 14, 3.8}, 45, 990, std::nullopt, {reference_wire(1000.0)}));
  lines.push_back(mooring_line("B", {58, -14, 3.8}, 135, 994, std::nullopt, {reference_wire(1000.0)}));
  lines.push_back(mooring_line("C", {-58, 14, 3.8}, 315, 985, std::nullopt, {reference_wire(1000.0)}));
  lines.push_back(mooring_line("D", {-58, -14, 3.8}, 225, 990, 300e3, {reference_wire(std::nullopt)}));
  lines.push_back(mooring_line("E", {0, 15, 3.8}, 0, 950, std::nullopt, {reference_wire(1000.0)}));
  Case c = make_mooring_case(d);
  HullEquilibrium rest;
  rest.forces = hull_forces(c.spread, c.hull, HullOffset::Zero(), rest.lines);
  for (std::size_t i = 0; i < expected.size(); ++i) expect_line(expected[i], c.spread, rest, i);
}

TEST(mooring_statics, chains_behind_wires_are_those_of_the_collocation) {
  Description d = reference_barge();
  const Json expected = expected_case("MO2-chain-wire")["static"]["moorings"];
  const auto line = [&](const char* name, const Vec3& fairlead, double azimuth, double distance,
                        std::optional<double> tension) {
    const std::optional<double> wire = tension ? std::nullopt : std::optional(660.0);
    d.moorings->lines.push_back(
        mooring_line(name, fairlead, azimuth, distance, tension, {reference_wire(wire), reference_chain(250.0)}));
  };
  line("A", {58, 14, 3.8}, 45, 900, std::nullopt);
  line("B", {58, -14, 3.8}, 135, 903, std::nullopt);
  line("C", {-58, 14, 3.8}, 315, 900, 500e3);
  line("D", {-58, -14, 3.8}, 225, 420, 900e3);
  Case c = make_mooring_case(d);
  HullEquilibrium rest;
  rest.forces = hull_forces(c.spread, c.hull, HullOffset::Zero(), rest.lines);
  for (std::size_t i = 0; i < expected.size(); ++i) expect_line(expected[i], c.spread, rest, i);
}

std::vector<VesselLoadDescription> pipe_load() {
  return {vessel_load("pipe", {-60, 0, 0}, {-205.5e3, 0, 0})};
}

TEST(mooring_statics, a_barge_on_eight_lines_lies_where_the_collocation_says) {
  const Json expected = expected_case("MO8-sym");
  Case c = make_mooring_case(eight_line_barge());
  expect_stage(expected["static"], c.spread, find_hull_equilibrium(c.spread, c.hull, HullOffset::Zero()));
  const std::vector<VesselLoadDescription> pipe = pipe_load();
  const VesselLoadDescription current = vessel_load("current", {0, 0, -2.6}, {0, 400e3, 0});
  const VesselLoadDescription yaw = vessel_load("yaw", Vec3::Zero(), Vec3::Zero(), {0, 0, 8000e3});
  const std::vector<std::vector<VesselLoadDescription>> stages = {{}, pipe, {current}, {pipe[0], current, yaw}};
  for (std::size_t i = 0; i < stages.size(); ++i) {
    c.hull.loads = stages[i];
    const HullEquilibrium rest = find_hull_equilibrium(c.spread, c.hull, HullOffset::Zero());
    ASSERT_FALSE(rest.error) << *rest.error;
    expect_stage(expected["operation"]["stages"][i], c.spread, rest);
  }
}

TEST(mooring_statics, a_pull_ahead_hauls_and_pays_out_what_the_collocation_says) {
  const Json expected = expected_case("MO8-pull-ahead")["operation"];
  Case c = make_mooring_case(eight_line_barge());
  c.hull.loads = pipe_load();
  const HullEquilibrium before = find_hull_equilibrium(c.spread, c.hull, HullOffset::Zero());
  expect_stage(expected["stages"][0], c.spread, before);
  HullOffset hull_offset = before.offset;
  hull_offset[0] += 12.0;
  const HullEquilibrium after = plan_lengths(c.spread, c.hull, hull_offset, horizontal_pulls(c.spread, before.lines));
  ASSERT_FALSE(after.error) << *after.error;
  expect_stage(expected["stages"][1], c.spread, after);
}

TEST(mooring_statics, a_move_ahead_and_back_ends_where_it_began) {
  Case c = make_mooring_case(eight_line_barge());
  c.hull.loads = pipe_load();
  const HullEquilibrium before = find_hull_equilibrium(c.spread, c.hull, HullOffset::Zero());
  const Eigen::VectorXd pulls = horizontal_pulls(c.spread, before.lines);
  const MooringSpread first = c.spread;
  HullOffset hull_offset = before.offset;
  hull_offset[0] += 12.0;
  plan_lengths(c.spread, c.hull, hull_offset, pulls);
  const HullEquilibrium back = plan_lengths(c.spread, c.hull, before.offset, pulls);
  EXPECT_LT((back.offset - before.offset).lpNorm<Eigen::Infinity>(), 1e-8);
  for (std::size_t i = 0; i < c.spread.lines.size(); ++i) {
    EXPECT_NEAR(c.spread.lines[i].line.length(), first.lines[i].line.length(), 1e-6);
  }
}

TEST(mooring_statics, the_slope_of_the_forces_is_that_of_their_differences) {
  Description d = eight_line_barge();
  d.vessel.heel = 0.03;
  d.vessel.trim = 0.02;
  Case c = make_mooring_case(d);
  c.hull.loads = {vessel_load("load", {-60, 3, 8}, {-2e5, 3e5, -1e5}, {1e6, 2e6, 3e6})};
  c.hull.restoring_point_V = {2.0, 1.0, 0.8};
  c.hull.surroundings = [](double yaw) {
    return Vec6(2e6 * (Vec6() << std::cos(yaw), std::sin(2.0 * yaw), 0.0, 3.0, -2.0, 40.0 * std::cos(yaw)).finished());
  };
  HullOffset hull_offset;
  hull_offset << 1.0, -2.0, 0.1, 0.04, -0.03, 0.3;
  std::vector<CatenarySolution> lines;
  const HullForces hull_force_here = hull_forces(c.spread, c.hull, hull_offset, lines);
  for (int k = 0; k < 6; ++k) {
    const double step = k < 3 ? 1e-3 : 1e-5;
    HullOffset more = hull_offset, less = hull_offset;
    more[k] += step;
    less[k] -= step;
    const Vec6 slope =
        (hull_forces(c.spread, c.hull, less, lines).total - hull_forces(c.spread, c.hull, more, lines).total) /
        (2.0 * step);
    for (int i = 0; i < 6; ++i) {
      const double scale = (i < 3 ? 1e6 : 1e8) * (k < 3 ? 1.0 : 60.0);
      EXPECT_NEAR(hull_force_here.slope(i, k), slope[i], 1e-5 * scale) << i << k;
    }
  }
}

TEST(mooring_statics, does_not_depend_on_the_heading_of_the_world) {
  const auto rest_at = [](double turn) {
    Description d = eight_line_barge();
    d.vessel.heading += turn;
    for (MooringLineDescription& line : d.moorings->lines) *line.azimuth += turn;
    Case c = make_mooring_case(d);
    c.hull.loads = {vessel_load("current", {0, 0, -2.6}, {-2e5, 4e5, 0}),
                    vessel_load("yaw", {0, 0, 0}, {0, 0, 0}, {0, 0, 8e6})};
    return find_hull_equilibrium(c.spread, c.hull, HullOffset::Zero()).offset;
  };
  const HullOffset first = rest_at(0.0);
  for (const double turn : {1.5707963267948966, 3.787364476827695}) {
    EXPECT_LT((rest_at(turn) - first).lpNorm<Eigen::Infinity>(), 1e-8);
  }
}

// The figures below take the pipe's pull as a constant force at midship.

struct BargeRow {
  double surge, sway, yaw_deg, tensions[8];
};
void expect_row(const BargeRow& row, const HullEquilibrium& rest) {
  ASSERT_FALSE(rest.error) << *rest.error;
  EXPECT_NEAR(rest.offset[0], row.surge, 0.006);  // the table's last digit, and 1e-3 of the largest
  EXPECT_NEAR(rest.offset[1], row.sway, std::max(0.001, 1e-3 * std::abs(row.sway)));
  EXPECT_NEAR(rest.offset[5] * 57.29577951308232, row.yaw_deg, std::max(0.001, 1e-3 * std::abs(row.yaw_deg)));
  for (std::size_t i = 0; i < 8; ++i) {
    if (rest.lines[i].pull > 0.0) {
      EXPECT_NEAR(rest.lines[i].tension() / 1e3, row.tensions[i], 1e-3 * 400.0) << i;
    }
  }
}

TEST(mooring_statics, the_planned_lengths_of_the_barge_take_up_the_pipes_pull) {
  Case c = make_mooring_case(bgl1_barge());
  EXPECT_NEAR(c.spread.lines[0].line.length(), 1007.339, 0.001);
  c.hull.loads = {vessel_load("pipe", {0, 0, 0}, {-205.6e3, 0, 0})};
  std::vector<CatenarySolution> drawn;
  hull_forces(c.spread, c.hull, HullOffset::Zero(), drawn);
  const HullEquilibrium rest = plan_lengths(c.spread, c.hull, HullOffset::Zero(), horizontal_pulls(c.spread, drawn));
  expect_row({0, 0, 0, {346.6, 321.7, 278.3, 253.4, 253.4, 278.3, 321.7, 346.6}}, rest);
  const double lengths[] = {1006.40, 1006.88, 1007.83, 1008.45};
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(c.spread.lines[i].line.length(), lengths[i], 0.006);  // two digits given
  const MooringSpread planned = c.spread;
  const VesselLoadDescription pipe = c.hull.loads[0];
  c.hull.loads = {pipe, vessel_load("drift", {0, 0, 0}, {0, 217.8e3, 0})};
  expect_row({-0.003, 1.184, -0.100, {321.9, 276.4, 234.3, 234.7, 273.9, 331.9, 375.3, 373.6}},
             find_hull_equilibrium(planned, c.hull, HullOffset::Zero()));
  c.hull.loads[1].force.y() = 483.1e3;
  expect_row({-0.012, 2.593, -0.210, {295.1, 231.7, 192.7, 214.4, 300.5, 409.6, 451.2, 409.1}},
             find_hull_equilibrium(planned, c.hull, HullOffset::Zero()));
  MooringSpread parted = planned;
  parted.lines[6].parted = true;
  expect_row({-0.79, 7.92, 5.30, {212.1, 82.3, 176.4, 169.5, 339.2, 429.6, 0, 763.7}},
             find_hull_equilibrium(parted, c.hull, HullOffset::Zero()));
  c.hull.loads.clear();
  expect_row({1.124, 0, 0, {296.3, 299.1, 299.2, 295.6, 295.6, 299.2, 299.1, 296.3}},
             find_hull_equilibrium(planned, c.hull, HullOffset::Zero()));
}

TEST(mooring_statics, the_barges_lines_have_the_stiffness_of_the_closed_form) {
  Case c = make_mooring_case(bgl1_barge());
  const HullEquilibrium rest = find_hull_equilibrium(c.spread, c.hull, HullOffset::Zero());
  const Mat6 k = stiffness_about(rest.forces.mooring_stiffness, rest.forces.moorings.head<3>(), {0.0, 0.0, 0.818});
  const auto near = [&](int i, int j, double want) {
    EXPECT_NEAR(k(i - 1, j - 1), want, 5e-4 * std::abs(want)) << i << j;
  };
  near(1, 1, 1.8479e5);
  near(2, 2, 1.8479e5);
  near(3, 3, 1.1845e4);
  near(5, 5, 1.3382e8);
  near(6, 6, 5.1281e8);
  near(2, 4, -9.4315e5);
  near(1, 5, 2.455e6);
  near(4, 4, 2.7285e7);
  EXPECT_NEAR(rest.forces.moorings[2], -694.1e3, 200.0);
}

TEST(mooring_statics, moves_of_twelve_metres_take_the_lengths_of_the_closed_form) {
  Case c = make_mooring_case(bgl1_barge());
  std::vector<CatenarySolution> drawn;
  hull_forces(c.spread, c.hull, HullOffset::Zero(), drawn);
  const Eigen::VectorXd wished = horizontal_pulls(c.spread, drawn);
  c.hull.loads = {vessel_load("pipe", {0, 0, 0}, {-205.6e3, 0, 0})};
  const HullEquilibrium before = plan_lengths(c.spread, c.hull, HullOffset::Zero(), wished);
  const MooringSpread first = c.spread;
  HullOffset hull_offset = HullOffset::Zero();
  hull_offset[0] = 12.0;
  const HullEquilibrium after = plan_lengths(c.spread, c.hull, hull_offset, wished);
  const double change[] = {-10.90, -5.02, 5.17, 10.96};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(c.spread.lines[i].line.length() - first.lines[i].line.length(), change[i], 0.0055);  // two digits given
    EXPECT_LT(std::abs(after.lines[i].tension() - before.lines[i].tension()), 3.3e3);
  }
}

TEST(mooring_statics, bounds_of_the_tension_hold_and_the_rest_balances) {
  Case c = make_mooring_case(bgl1_barge());
  std::vector<CatenarySolution> drawn;
  hull_forces(c.spread, c.hull, HullOffset::Zero(), drawn);
  c.hull.loads = {vessel_load("pipe", {0, 0, 0}, {-205.6e3, 0, 0})};
  const HullEquilibrium rest =
      plan_lengths(c.spread, c.hull, HullOffset::Zero(), horizontal_pulls(c.spread, drawn), {258e3, 340e3});
  ASSERT_FALSE(rest.error) << *rest.error;
  for (const CatenarySolution& line : rest.lines) {
    EXPECT_GT(line.tension(), 258e3 - 1.0);
    EXPECT_LT(line.tension(), 340e3 + 1.0);
  }
  EXPECT_LT(rest.offset.head<2>().norm(), 1e-6);
  // 60 kN more ahead than astern is 159 kN in all: too little.
  EXPECT_TRUE(
      plan_lengths(c.spread, c.hull, HullOffset::Zero(), horizontal_pulls(c.spread, drawn), {270e3, 330e3}).error);
}

TEST(mooring_statics, says_what_does_not_hold_the_hull) {
  Description d = eight_line_barge();
  d.moorings->lines.resize(1);
  Case single = make_mooring_case(d);
  single.hull.loads = {vessel_load("turn", Vec3::Zero(), Vec3::Zero(), {0, 0, 8000e3})};  // no single force balances it
  const HullEquilibrium rest = find_hull_equilibrium(single.spread, single.hull, HullOffset::Zero());
  ASSERT_TRUE(rest.error);
  EXPECT_NE(rest.error->find("three are needed"), std::string::npos) << *rest.error;
  Case short_line = make_mooring_case(eight_line_barge());
  short_line.spread.lines[2].line.set_first_segment(600.0);
  const HullEquilibrium none = find_hull_equilibrium(short_line.spread, short_line.hull, HullOffset::Zero());
  ASSERT_TRUE(none.error);
  EXPECT_NE(none.error->find("\"S3\" is too short to reach"), std::string::npos) << *none.error;
}

TEST(mooring_statics, buoys_need_a_length_to_count_from) {
  Description d = eight_line_barge();
  LinePointDescription buoy;
  buoy.at = 300.0;
  d.moorings->lines[3].points = {buoy};
  const SpreadOutcome outcome =
      build_spread(*d.moorings, SeabedSurface(Vec3(0.0, 0.0, -89.0), Vec3::UnitZ()), Mat3::Identity());
  ASSERT_TRUE(outcome.error);
  EXPECT_NE(outcome.error->find("\"S4\": give the length of its first segment"), std::string::npos) << *outcome.error;
}

TEST(mooring_statics, finds_a_hull_that_starts_far_from_its_rest) {
  Case c = make_mooring_case(eight_line_barge());
  HullOffset far;
  far << 40.0, -60.0, 1.0, 0.02, 0.01, 0.5;
  const HullEquilibrium rest = find_hull_equilibrium(c.spread, c.hull, far);
  ASSERT_FALSE(rest.error) << *rest.error;
  EXPECT_LT(rest.offset.head<2>().norm(), 1e-5);
}

}  // namespace
}  // namespace overbend
