#include "statics/moored/moored_statics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/constants.h"
#include "base/json.h"
#include "dynamics/run/simulation.h"
#include "recording/vessel_recorder.h"
#include "support/moored_lay.h"

namespace overbend {
namespace {

using testing::rest_of_hull;

const std::string kCases = std::string(OVERBEND_SOURCE_DIR) + "/validation/mooring_cases/";

Description described(const std::string& name) {
  ModelReading result = read_model(kCases + name + ".yaml");
  EXPECT_TRUE(result.description) << name;
  return std::move(*result.description);
}

Json read_expected(const std::string& name) {
  return read_json_file(kCases + name + ".expected.json");
}

/// Tolerances: what the collocation and its second method agree to, with room for their differences.
void expect_line(const Json& want, const MooringLineResult& line) {
  const double tension = want["fairlead_tension"];
  EXPECT_EQ(want["name"], line.name);
  EXPECT_NEAR(line.fairlead_tension, tension, 1e-6 * tension);
  EXPECT_NEAR(line.horizontal, want["horizontal"], 1e-6 * tension);
  EXPECT_NEAR(line.declination, want["declination"], 1e-6);
  EXPECT_NEAR(line.anchor_tension, want["anchor_tension"], 1e-6 * tension);
  EXPECT_NEAR(line.anchor_uplift, want["anchor_uplift"], 1e-3);
  EXPECT_NEAR(line.suspended_length, want["suspended_length"], 1e-4);
  EXPECT_NEAR(line.touchdown_distance, want["touchdown_distance"], 1e-4);
  EXPECT_NEAR(line.on_bed, want["length_on_bed"], 1e-4);
  EXPECT_NEAR(line.horizontal_distance, want["horizontal_distance"], 1e-5);
  EXPECT_NEAR(line.first_segment_length, want["first_segment_length"], 1e-5);
  EXPECT_NEAR(std::remainder(line.azimuth - want["azimuth"].get<double>(), 6.283185307179586), 0.0, 1e-7);
}

void expect_state(const Json& want, const MooredState& state) {
  ASSERT_EQ(state.moorings.size(), want["moorings"].size());
  for (std::size_t i = 0; i < state.moorings.size(); ++i) expect_line(want["moorings"][i], state.moorings[i]);
  if (want.contains("vessel")) {
    const Json& sample = want["vessel"];
    EXPECT_NEAR(state.vessel.surge, sample["surge"], 1e-5);
    EXPECT_NEAR(state.vessel.sway, sample["sway"], 1e-5);
    EXPECT_NEAR(state.vessel.heave, sample["heave"], 1e-6);
    EXPECT_NEAR(state.vessel.roll, sample["roll"], 1e-7);
    EXPECT_NEAR(state.vessel.pitch, sample["pitch"], 1e-7);
    EXPECT_NEAR(state.vessel.yaw, sample["yaw"], 1e-7);
  }
}

void expect_case(const std::string& name) {
  const MooringResults results = rest_of_hull(described(name));
  const Json want = read_expected(name);
  if (want.contains("static")) expect_state(want["static"], results.rest);
  if (!want.contains("operation")) return;
  const Json& stages = want["operation"]["stages"];
  ASSERT_EQ(results.stages.size(), stages.size());
  for (std::size_t i = 0; i < stages.size(); ++i) {
    EXPECT_EQ(results.stages[i].name, stages[i]["name"]);
    expect_state(stages[i], results.stages[i]);
  }
}

TEST(moored_statics, wires_of_a_held_hull_are_those_of_the_reference) {
  expect_case("MO1-wire");
}

TEST(moored_statics, chains_and_wires_of_a_held_hull_are_those_of_the_reference) {
  expect_case("MO2-chain-wire");
}

TEST(moored_statics, stages_of_a_moored_hull_are_those_of_the_reference) {
  expect_case("MO8-sym");
}

TEST(moored_statics, a_pull_ahead_is_that_of_the_reference) {
  expect_case("MO8-pull-ahead");
  const MooringResults results = rest_of_hull(described("MO8-pull-ahead"));
  const Json lines = read_expected("MO8-pull-ahead")["operation"]["pull_ahead"]["lines"];
  for (std::size_t i = 0; i < lines.size(); ++i) {
    EXPECT_NEAR(results.winches[i].after - results.winches[i].before, lines[i]["winch"], 1e-5);
  }
}

TEST(moored_statics, moves_one_after_the_other_haul_the_bow_lines_and_pay_out_the_stern_lines) {
  Description d = described("MO8-pull-ahead");
  d.operation.moves = 3;
  const MooringResults results = rest_of_hull(d);
  ASSERT_EQ(results.stages.size(), 4);
  EXPECT_NEAR(results.stages.back().vessel.surge - results.stages.front().vessel.surge, 36.0, 1e-6);
  EXPECT_LT(results.winches[0].after, results.winches[0].before - 30.0);
  EXPECT_GT(results.winches[3].after, results.winches[3].before + 30.0);
}

TEST(moored_statics, find_lengths_keeps_the_hull_where_it_is_drawn) {
  Description d = described("MO8-pull-ahead");
  d.vessel.loads = d.operation.loads;
  d.operation = {};
  d.moorings->find = FindMooring::lengths;
  const MooredState held = rest_of_hull(d).rest;
  EXPECT_NEAR(held.vessel.surge, 0.0, 1e-7);
  EXPECT_GT(held.moorings[0].fairlead_tension, 350e3);
  d.moorings->find = FindMooring::pose;
  EXPECT_LT(rest_of_hull(d).rest.vessel.surge, -0.9);
}

TEST(moored_statics, lines_that_say_nothing_of_friction_have_that_of_the_seabed) {
  Description d = described("MO1-wire");
  for (MooringLineDescription& line : d.moorings->lines) {
    for (LineSegmentDescription& segment : line.segments) segment.type.friction.reset();
  }
  d.moorings->bed_friction.reset();
  d.environment.seabed.friction_axial = d.environment.seabed.friction_lateral = 0.3;
  const MooringResults of_bed = rest_of_hull(d);
  d.moorings->bed_friction = 0.3;
  const MooringResults prescribed = rest_of_hull(d);
  for (std::size_t i = 0; i < prescribed.rest.moorings.size(); ++i) {
    const MooringLineResult& line = of_bed.rest.moorings[i];
    EXPECT_EQ(line.anchor_tension, prescribed.rest.moorings[i].anchor_tension);
    EXPECT_EQ(line.fairlead_tension, prescribed.rest.moorings[i].fairlead_tension);
    if (line.on_bed > 1.0) {
      EXPECT_LT(line.anchor_tension, line.horizontal - 1.0);
    }
  }
}

TEST(moored_statics, warns_of_what_a_crew_would_mend) {
  Description d = described("MO8-sym");
  d.operation = {};
  d.moorings->lines[0].segments[0].length = 1100.0;
  d.moorings->lines[0].tension.reset();
  d.moorings->lines[5].segments[0].type.breaking_load = 200e3;
  d.moorings->lines[6].anchor_holding.holding = 100e3;
  WinchDescription weak;
  weak.name = "weak";
  weak.brake = 150e3;
  d.moorings->winches = {weak};
  d.moorings->lines[6].winch = "weak";
  d.moorings->objects = {{"pipeline", {{-400.0, 300.0, -88.0}, {400.0, 300.0, -88.0}}}};
  const ModelEquilibrium found = testing::SolvedHull(d).rest;
  const MooringResults& results = found.moorings.value();
  const auto warned = [&](const std::string& line, const std::string& of) {
    return std::ranges::any_of(messages(found.findings), [&](const std::string& warning) {
      return warning.find("\"" + line + "\"") != std::string::npos && warning.find(of) != std::string::npos;
    });
  };
  EXPECT_TRUE(warned("S1", "slack"));
  EXPECT_TRUE(warned("P2", "breaking load"));
  EXPECT_TRUE(warned("P3", "holding power"));
  EXPECT_TRUE(warned("P3", "brake renders"));
  EXPECT_FALSE(warned("P4", "brake renders"));
  for (const MooringLineResult& line : results.rest.moorings) {
    ASSERT_TRUE(line.clearance);
    EXPECT_EQ(line.nearest_object, "pipeline");
  }
}

// A hull whose place is given needs no line at all.
TEST(moored_statics, too_few_lines_are_no_warning_on_a_hull_that_is_held) {
  Description d = described("MO8-sym");
  d.operation = {};
  d.vessel.hydrostatics.reset();
  d.moorings->lines.resize(2);
  for (const std::string& warning : messages(testing::SolvedHull(d).rest.findings)) {
    EXPECT_EQ(warning.find("fewer than three"), std::string::npos) << warning;
  }
}

TEST(moored_statics, warns_of_lines_that_a_bed_as_it_is_would_bear_elsewhere) {
  const auto warnings_over = [](double height) {
    Description d = described("MO8-sym");
    d.operation = {};
    // A ridge across the lay route, 600 m astern of the shoe: the stern lines lie over it.
    d.environment.seabed.profile = {
        {-2000.0, 89.0}, {550.0, 89.0}, {600.0, 89.0 - height}, {650.0, 89.0}, {2000.0, 89.0}};
    std::vector<std::string> reported;
    for (const std::string& warning : messages(testing::SolvedHull(d).rest.findings)) {
      if (warning.find("in the seabed") != std::string::npos) reported.push_back(warning);
    }
    return reported;
  };
  EXPECT_TRUE(warnings_over(0.2).empty());
  const std::vector<std::string> messages = warnings_over(12.0);
  ASSERT_GE(messages.size(), 2U);
  for (const std::string& warning : messages) {
    EXPECT_NE(warning.find("up to 12.0 m"), std::string::npos) << warning;
    EXPECT_NE(warning.find("assume a straight bed"), std::string::npos) << warning;
  }
}

/// The hull of MO8-sym with the numbers of a hydrodynamic file: balanced by its crew, or as given.
Description coupled_barge(Ballast ballast) {
  Description d = described("MO8-sym");
  d.operation = {};
  d.vessel.hydrostatics.reset();
  CoupledHullDescription& hull = d.vessel.coupled.emplace();
  hull.ballast = ballast;
  hull.mass = 19121.58e3;
  hull.centre_of_gravity = {0.0, 0.0, 0.818};
  hull.gyration = {10.5, 30.0, 30.0};
  HydrodynamicData& data = hull.data.emplace();
  data.origin_V = hull.centre_of_gravity;
  data.hydrostatic_stiffness.diagonal() << 0.0, 0.0, 36198.9e3, 2075448e3, 42799210e3, 0.0;
  RadiationPoint slow;
  slow.omega = 0.1;
  slow.added_mass.diagonal() << 1.858e6, 8.722e6, 9.988e7, 1.491e9, 5.867e10, 8.617e9;
  data.radiation = {slow};
  return d;
}

double find_period(const MooredState& state, const std::string& mode) {
  for (const PeriodResult& period_result : state.vessel.natural_periods) {
    if (period_result.mode == mode) return period_result.period;
  }
  return 0.0;
}

TEST(moored_statics, a_crew_that_ballasts_keeps_the_draught_and_the_trim) {
  Description d = coupled_barge(Ballast::trim);
  d.vessel.loads = {{"pipe", {-60, 0, 0}, {-205.6e3, 0, -250e3}, Vec3::Zero()}};
  d.moorings->find = FindMooring::lengths;
  const VesselResult held = rest_of_hull(d).rest.vessel;
  for (const double offset : {held.surge, held.sway, held.heave, held.roll, held.pitch, held.yaw}) {
    EXPECT_NEAR(offset, 0.0, 1e-7);
  }
  d.vessel.coupled->ballast = Ballast::as_given;
  const VesselResult sunk = rest_of_hull(d).rest.vessel;
  EXPECT_NEAR(sunk.heave, -(780e3 + 250e3) / 36198.9e3, 3e-4);
  EXPECT_LT(sunk.pitch, -1e-4);  // the pipe pulls the stern down
}

TEST(moored_statics, natural_periods_are_those_of_mass_and_lines) {
  const MooredState rest = rest_of_hull(coupled_barge(Ballast::trim)).rest;
  // Surge by itself: the lines' 221 kN/m and 19,122 t with 1,858 t of water; pitch takes part by a permille.
  EXPECT_NEAR(find_period(rest, "surge"),
              6.283185307179586 * std::sqrt((19121.58e3 + 1.858e6) / rest.vessel.stiffness[0]), 0.2);
  EXPECT_NEAR(find_period(rest, "sway"),
              6.283185307179586 * std::sqrt((19121.58e3 + 8.722e6) / rest.vessel.stiffness[7]), 0.3);
  EXPECT_EQ(rest.vessel.natural_periods.size(), 6);
}

/// The moored example without its pipe and its current, in waves towards a direction anticlockwise from the bow.
Description in_waves(double from_bow_deg, FindMooring find) {
  Description d = read_model(OVERBEND_SOURCE_DIR "/examples/bgl1-moored.yaml").description.value();
  d.has_pipe = false;
  d.environment.current.clear();
  // The bow points east: towards the azimuth 90 - from_bow, so from the opposite.
  d.environment.waves.front().from = (270.0 - from_bow_deg) * 0.017453292519943295;
  d.moorings->find = find;
  d.statics.mean_drift = true;
  return d;
}

TEST(moored_statics, lines_hold_the_mean_drift_where_it_acts) {
  // 2 int S D: -30.9 and 76.6 kN, 1,237 kN m (1,264 where the table's value at 0.5 rad/s is kept) and 217.8 kN by an
  // independent integration; the sea's 200 components are drawn, which is good for a percent.
  const std::vector<double> quartering = rest_of_hull(in_waves(135.0, FindMooring::lengths)).rest.mooring_force;
  EXPECT_NEAR(quartering[0], 30.9e3, 0.6e3);
  EXPECT_NEAR(quartering[1], -76.6e3, 1.2e3);
  EXPECT_NEAR(quartering[5], -1250e3, 40e3);
  const MooringResults beam = rest_of_hull(in_waves(90.0, FindMooring::lengths));
  EXPECT_NEAR(beam.rest.mooring_force[1], -217.8e3, 2.2e3);
  EXPECT_NEAR(beam.rest.vessel.sway, 0.0, 1e-7);
  Description without = in_waves(90.0, FindMooring::lengths);
  without.statics.mean_drift.reset();
  EXPECT_NEAR(rest_of_hull(without).rest.mooring_force[1], 0.0, 1.0);
}

TEST(moored_statics, the_mean_drift_shifts_the_hull_on_its_lines) {
  const MooredState rest = rest_of_hull(in_waves(90.0, FindMooring::pose)).rest;
  EXPECT_NEAR(rest.vessel.sway, 1.18, 0.02 * 1.18);  // 217.8 kN on 184.8 kN/m and more
  EXPECT_NEAR(rest.vessel.surge, 0.0, 0.01);
}

TEST(moored_statics, current_and_wind_follow_the_heading_of_the_hull) {
  Description d = in_waves(90.0, FindMooring::pose);
  d.environment.current = {{0.0, 1.0, 0.0}, {89.0, 1.0, 0.0}};  // to the north, on the side
  d.vessel.loads = {{"tug", Vec3::Zero(), Vec3::Zero(), Vec3(0.0, 0.0, 60e6)}};
  d.statics.mean_drift.reset();
  const MooredState rest = rest_of_hull(d).rest;
  ASSERT_GT(rest.vessel.yaw, 0.05);  // bow to port, into the current
  // The strips give 1/2 rho L T C_y V^2 cos^2 across, and Munk's moment turns the hull further out of the flow.
  const double V = 1.0, c = std::cos(rest.vessel.yaw), s = std::sin(rest.vessel.yaw);
  const double across = 0.5 * 1025.0 * 120.0 * 5.182 * 0.8 * V * V * c * c;
  const double ahead = rest.mooring_force[0] * c + rest.mooring_force[1] * s;
  EXPECT_NEAR(-rest.mooring_force[0] * s + rest.mooring_force[1] * c, -across, 0.002 * across);
  EXPECT_LT(ahead, 0.0);
}

/// The pulls that lines have as drawn change as little as balances what pulls astern, whether the hull is ballasted or
/// not: 346.6, 321.7, 278.3 and 253.4 kN by an independent prototype.
TEST(moored_statics, lengths_change_the_tensions_that_were_wished_as_little_as_balances_the_load) {
  for (const Ballast ballast : {Ballast::trim, Ballast::as_given}) {
    Description d = in_waves(90.0, FindMooring::lengths);
    d.statics.mean_drift.reset();
    d.vessel.coupled->ballast = ballast;
    d.vessel.loads = {{"pipe", Vec3::Zero(), Vec3(-205.6e3, 0.0, 0.0), Vec3::Zero()}};
    const std::vector<MooringLineResult> lines = rest_of_hull(d).rest.moorings;
    const std::array<double, 4> tensions = {346.6e3, 321.7e3, 278.3e3, 253.4e3};
    for (std::size_t i = 0; i < tensions.size(); ++i) {
      EXPECT_NEAR(lines[i].fairlead_tension, tensions[i], 0.1e3) << i;
      EXPECT_NEAR(lines[7 - i].fairlead_tension, tensions[i], 0.1e3) << i;
    }
  }
}

/// Moorings of a hull that is drawn with heel and trim as well: down is down.
TEST(moored_statics, a_load_straight_down_shifts_no_hull_that_is_drawn_heeled_in_time_as_in_statics) {
  Description d = in_waves(90.0, FindMooring::pose);
  d.environment.waves.front().type = WaveType::none;
  d.vessel.heel = 2.0 * kDegree;
  d.vessel.trim = 1.5 * kDegree;
  d.vessel.loads = {{"crane", Vec3::Zero(), Vec3(0.0, 0.0, -1e6), Vec3::Zero()}};
  d.dynamics = DynamicSettings{};
  d.dynamics->duration = 1.0;
  const testing::SolvedHull hull(d);
  const VesselResult& rest = hull.rest.moorings->rest.vessel;
  Simulation simulation(hull.model, hull.start(), 0.0, dynamic_options(hull.model));
  ASSERT_FALSE(simulation.failure());
  const VesselPose& pose = simulation.present().assembly->surroundings().bodies[0].pose;
  const auto shift = shift_between(hull.model.nominal_pose, pose);
  EXPECT_NEAR(shift[0], rest.surge, 0.01);
  EXPECT_NEAR(shift[1], rest.sway, 0.01);
  EXPECT_NEAR(shift[2], rest.heave, 1e-3);
}

TEST(moored_statics, a_hull_as_given_sinks_and_trims_under_lines_and_pipe) {
  // Eight lines at 300 kN pull down 694 kN: 19 mm on 36.2 MN/m. A pipe of 250 kN at the stern: 0.020 deg on 4.28e10 N
  // m.
  Description d = in_waves(90.0, FindMooring::lengths);
  d.statics.mean_drift.reset();
  d.vessel.coupled->ballast = Ballast::as_given;
  const VesselResult lines = rest_of_hull(d).rest.vessel;
  EXPECT_NEAR(lines.heave, -0.0192, 0.0002);
  EXPECT_NEAR(lines.pitch, 0.0, 1e-6);
  d.vessel.loads = {{"pipe", Vec3(-60.0, 0.0, 0.0), Vec3(0.0, 0.0, -250e3), Vec3::Zero()}};
  const VesselResult pipe = rest_of_hull(d).rest.vessel;
  EXPECT_NEAR(pipe.heave, -0.0192 - 250e3 / 36.2e6, 0.0002);
  EXPECT_NEAR(pipe.pitch, -0.020 * 0.017453292519943295, 0.02 * 0.020 * 0.017453292519943295);
}

TEST(moored_statics, says_which_line_is_too_short) {
  Description d = described("MO8-sym");
  d.moorings->lines[2].segments[0].length = 700.0;
  d.moorings->lines[2].tension.reset();
  Model model = build_model(d);
  const std::optional<StaticFailure> failure = solve_moored_hull(model).failure;
  ASSERT_TRUE(failure);
  EXPECT_NE(failure->why.find("\"S3\" is too short to reach: 700.00 m"), std::string::npos) << failure->why;
}

}  // namespace
}  // namespace overbend
