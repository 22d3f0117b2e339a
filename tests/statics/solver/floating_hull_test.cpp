/// A vessel that floats free on lines that stand by themselves, and lines between bodies: against forces balanced by
/// hand.
#include "statics/solver/floating_hull.h"

#include <gtest/gtest.h>

#include "statics/moored/moored_lay.h"
#include "support/line_cases.h"
#include "support/lines_for_moorings.h"

namespace overbend {
namespace {

constexpr double kStiffness = 2e6;  ///< EA of the wires [N].

/// A hull 100 m long, the bow to the east, that floats with given hydrostatics.
Description hull_afloat() {
  Description d = testing::water_alone(1025.0, 100.0);
  d.vessel.length = 100.0;
  d.vessel.draught = 4.0;
  d.vessel.heading = 0.5 * std::numbers::pi;
  d.vessel.hydrostatics = HydrostaticsDescription{2e7, 2e9, 2e10};
  return d;
}

BodyDescription body(const std::string& name, const Vec3& place, double heading) {
  BodyDescription made;
  made.name = name;
  made.place = place;
  made.hull.heading = heading;
  return made;
}

LineEndDescription on_body(const std::string& name, const Vec3& point) {
  LineEndDescription end;
  end.kind = LineEndKind::body;
  end.body = name;
  end.at = point;
  return end;
}

LineEndDescription fixed(const Vec3& point) {
  LineEndDescription end;
  end.at = point;
  return end;
}

FreeLineDescription between(const std::string& name, const LineTypeDescription& type, double length,
                            const LineEndDescription& first, const LineEndDescription& second) {
  FreeLineDescription line;
  line.name = name;
  line.first = first;
  line.second = second;
  line.segments = {{"", length, type}};
  return line;
}

/// Without weight and bending stiffness: straight.
FreeLineDescription wire(const std::string& name, double length, const LineEndDescription& first,
                         const LineEndDescription& second) {
  LineTypeDescription type;
  type.diameter = 0.05;
  type.axial_stiffness = kStiffness;
  return between(name, type, length, first, second);
}

constexpr double kRopeLength = 182.0, kRopeWeight = 20.0 * kGravity, kRopeStiffness = 5e7;

FreeLineDescription rope(const LineEndDescription& first, const LineEndDescription& second) {
  return between("hawser", testing::cable_type(20.0, 0.08, kRopeStiffness, 0.0, 1025.0), kRopeLength, first, second);
}

/// Tension of the rope in air with level ends: the elastic catenary with a horizontal tension.
double rope_span(double horizontal) {
  const double a = horizontal / kRopeWeight;
  return 2.0 * a * std::asinh(0.5 * kRopeLength / a) + horizontal * kRopeLength / kRopeStiffness;
}

void push(Description& d, const Vec3& point, const Vec3& force) {
  VesselLoadDescription load;
  load.at = point;
  load.force = force;
  d.vessel.loads.push_back(load);
}

const BodyResult& found(const ModelEquilibrium& equilibrium, const std::string& name) {
  return *std::ranges::find(equilibrium.bodies, name, &BodyResult::name);
}

TEST(hawser_between_bodies, is_suspended_as_between_the_same_places_that_are_fixed) {
  const Vec3 first(40.0, 10.0, 6.0), second(220.0, 10.0, 3.0);
  Description d = testing::water_alone(1025.0, 100.0);
  d.lines = {rope(fixed(first), fixed(second))};
  const ModelEquilibrium places = solve_lines(build_model(d));
  d.vessel.heading = 0.5 * std::numbers::pi;
  d.bodies = {body("tug", Vec3(240.0, 10.0, 0.0), 1.5 * std::numbers::pi)};  // its bow to the west
  d.lines = {rope(on_body("vessel", first), on_body("tug", Vec3(20.0, 0.0, 3.0)))};
  const ModelEquilibrium bodies = solve_lines(build_model(d));
  ASSERT_FALSE(bodies.failure);
  // Rounding of the places, over an axial stiffness of 50 MN.
  EXPECT_NEAR(bodies.lines[0].first.tension, places.lines[0].first.tension, 1e-3);
  EXPECT_NEAR(bodies.lines[0].second.tension, places.lines[0].second.tension, 1e-3);
}

TEST(hawser_between_bodies, pulls_its_tug_with_the_force_at_its_end_turned_round) {
  Description d = testing::water_alone(1025.0, 100.0);
  d.bodies = {body("barge", Vec3(-100.0, 0.0, 0.0), 0.5 * std::numbers::pi), body("tug", Vec3(100.0, 0.0, 0.0), 0.0)};
  d.lines = {rope(on_body("barge", Vec3(10.0, 0.0, 40.0)), on_body("tug", Vec3(0.0, 10.0, 40.0)))};
  const ModelEquilibrium found_all = solve_lines(build_model(d));
  const BodyResult& tug = found(found_all, "tug");
  const LineEndResult& end = found_all.lines[0].second;
  EXPECT_NEAR((tug.force + end.force).norm(), 0.0, 1e-9 * end.tension);
  // The tug's bow to the north, 10 m to port is 10 m west.
  const Vec3 arm(-10.0, 0.0, 40.0);
  EXPECT_NEAR((tug.moment + arm.cross(end.force)).norm(), 0.0, 1e-9 * end.tension);
  EXPECT_FALSE(tug.floats);
  EXPECT_NEAR(end.force.z(), 0.5 * kRopeWeight * kRopeLength, 1e-4 * kRopeWeight * kRopeLength);
  EXPECT_NEAR(rope_span(tug.force.head<2>().norm()), 180.0, 2e-3);  // two millimetres by the elements
}

TEST(wire_between_bodies, has_the_tension_of_its_stretch) {
  Description d = testing::water_alone(1025.0, 100.0);
  d.bodies = {body("west", Vec3(-50.0, 0.0, 0.0), 0.0), body("east", Vec3(50.0, 0.0, 0.0), 0.0)};
  d.lines = {wire("taut", 98.0, on_body("west", Vec3(0.0, 0.0, 2.0)), on_body("east", Vec3(0.0, 0.0, 2.0))),
             wire("slack", 101.0, on_body("west", Vec3(0.0, 0.0, 4.0)), on_body("east", Vec3(0.0, 0.0, 4.0)))};
  const ModelEquilibrium wires = solve_lines(build_model(d));
  ASSERT_FALSE(wires.failure) << wires.failure->what;
  EXPECT_NEAR(wires.lines[0].first.tension, kStiffness * (100.0 / 98.0 - 1.0), 1e-6);
  EXPECT_NEAR(found(wires, "east").force.x(), -kStiffness * (100.0 / 98.0 - 1.0), 1e-6);
  EXPECT_EQ(wires.lines[1].first.tension, 0.0);
  ASSERT_EQ(wires.findings.size(), 1U);
  EXPECT_EQ(wires.findings[0].code, FindingCode::line_slack);
  EXPECT_EQ(wires.findings[0].object, "line slack");
}

/// Two wires ahead and astern, 200 m long, pulled by a force: that of a current, say.
TEST(vessel_on_two_wires, gives_way_to_a_force_by_their_stiffness) {
  const double force = 50e3;
  Description d = hull_afloat();
  d.bodies = {body("tug", Vec3(250.0, 0.0, 0.0), 0.0)};
  d.lines = {wire("ahead", 196.0, on_body("vessel", Vec3(50.0, 0.0, 0.0)), on_body("tug", Vec3::Zero())),
             wire("astern", 196.0, on_body("vessel", Vec3(-50.0, 0.0, 0.0)), fixed(Vec3(-250.0, 0.0, 0.0)))};
  push(d, Vec3::Zero(), Vec3(-force, 0.0, 0.0));
  Model model = build_model(d);
  const ModelEquilibrium rest = solve_equilibrium(model);
  ASSERT_FALSE(rest.failure) << rest.failure->what;
  const BodyResult& vessel = found(rest, "vessel");
  EXPECT_TRUE(vessel.floats);
  EXPECT_NEAR(vessel.surge, -force / (2.0 * kStiffness / 196.0), 1e-6);
  EXPECT_NEAR(vessel.sway, 0.0, 1e-6);
  EXPECT_NEAR(vessel.yaw, 0.0, 1e-8);
  EXPECT_NEAR(rest.lines[0].first.tension - rest.lines[1].first.tension, force, 1e-3);
  EXPECT_NEAR(vessel.force.x(), force, 1e-3);
  EXPECT_NEAR(model.mean_pose.p_WV.x(), vessel.surge, 1e-9);
}

TEST(vessel_on_one_wire, drifts_until_the_wire_is_taut) {
  const double force = 80e3, length = 210.0;
  Description d = hull_afloat();
  d.lines = {wire("hawser", length, on_body("vessel", Vec3(50.0, 0.0, 0.0)), fixed(Vec3(250.0, 0.0, 0.0)))};
  push(d, Vec3::Zero(), Vec3(-force, 0.0, 0.0));
  const ModelEquilibrium rest = solve_lines(build_model(d));
  ASSERT_FALSE(rest.failure) << rest.failure->what << rest.failure->why;
  EXPECT_NEAR(found(rest, "vessel").surge, 200.0 - length * (1.0 + force / kStiffness), 1e-5);
  EXPECT_NEAR(rest.lines[0].first.tension, force, 1e-3);
}

/// A force abeam turns a hull whose hawser is at the bow until it heads away from the force.
TEST(vessel_on_one_wire, turns_into_the_line_of_a_force) {
  const double force = 80e3;
  Description d = hull_afloat();
  d.lines = {wire("hawser", 200.0, on_body("vessel", Vec3(50.0, 0.0, 0.0)), fixed(Vec3(250.0, 0.0, 0.0)))};
  push(d, Vec3::Zero(), Vec3(-std::cos(0.5) * force, -std::sin(0.5) * force, 0.0));
  const ModelEquilibrium rest = solve_lines(build_model(d));
  ASSERT_FALSE(rest.failure) << rest.failure->what << rest.failure->why;
  EXPECT_NEAR(found(rest, "vessel").yaw, 0.5, 1e-5);
  EXPECT_NEAR(rest.lines[0].first.tension, force, 1e-2);
}

TEST(vessel_on_a_rope, pulls_it_to_the_horizontal_tension_of_a_catenary) {
  const double force = 60e3;
  Description d = hull_afloat();
  d.bodies = {body("tug", Vec3(240.0, 0.0, 0.0), 0.0)};
  d.lines = {rope(on_body("vessel", Vec3(50.0, 0.0, 40.0)), on_body("tug", Vec3(0.0, 10.0, 40.0)))};
  push(d, Vec3::Zero(), Vec3(-force, 0.0, 0.0));
  const ModelEquilibrium rest = solve_lines(build_model(d));
  ASSERT_FALSE(rest.failure) << rest.failure->what << rest.failure->why;
  EXPECT_NEAR(-rest.lines[0].first.force.x(), force, 1e-2);
  const std::vector<LineNodeResult>& nodes = rest.lines[0].nodes;
  EXPECT_NEAR((nodes.back().place - nodes.front().place).head<2>().norm(), rope_span(force), 2e-3);
}

TEST(vessel_on_eight_lines, lies_as_on_mooring_lines_that_are_catenaries) {
  const Description d = testing::pushed_barge();
  Model moored = build_model(d);
  const ModelEquilibrium catenaries = solve_equilibrium(moored);
  ASSERT_FALSE(catenaries.failure);
  const MooredState& wanted = catenaries.moorings->rest;
  const ModelEquilibrium elements = solve_lines(build_model(testing::on_lines(d, wanted.moorings)));
  ASSERT_FALSE(elements.failure) << elements.failure->what;
  const BodyResult& vessel = found(elements, "vessel");
  // 0.3 mm and a thousandth of the turn are the elements'.
  EXPECT_NEAR(vessel.surge, wanted.vessel.surge, 5e-4);
  EXPECT_NEAR(vessel.sway, wanted.vessel.sway, 5e-4);
  EXPECT_NEAR(vessel.yaw, wanted.vessel.yaw, 1e-5);
  EXPECT_NEAR(vessel.heave, 0.0, 1e-6);  // ballast: trim
  for (std::size_t i = 0; i < wanted.moorings.size(); ++i) {
    EXPECT_NEAR(elements.lines[i].second.tension, wanted.moorings[i].fairlead_tension,
                2e-4 * wanted.moorings[i].fairlead_tension);
  }
  // The stiffness of the lines about the centre of gravity, of both in horizontal axes along the hull as drawn.
  const Mat6 stiffness = catenaries.solution->station_stiffness;
  for (const Eigen::Index k : {0, 1, 5}) {
    EXPECT_NEAR(elements.solution->station_stiffness(k, k), stiffness(k, k), 0.01 * stiffness(k, k)) << k;
  }
}

TEST(vessel_that_nothing_holds, is_rejected_by_the_names_of_its_directions) {
  Description d = hull_afloat();
  d.lines = {wire("slack", 210.0, on_body("vessel", Vec3(50.0, 0.0, 0.0)), fixed(Vec3(250.0, 0.0, 0.0)))};
  ModelEquilibrium rest = solve_lines(build_model(d));
  ASSERT_TRUE(rest.failure);
  EXPECT_TRUE(rest.failure->input);
  for (const char* direction : {"surge", "sway", "yaw"}) {
    EXPECT_NE(rest.failure->what.find(direction), std::string::npos) << rest.failure->what;
  }
  EXPECT_EQ(rest.failure->what.find("heave"), std::string::npos);
  // A hawser from the stern past the bow: in a line with the force, but the hull would turn round.
  d.lines = {wire("wrong", 290.0, on_body("vessel", Vec3(-50.0, 0.0, 0.0)), fixed(Vec3(250.0, 0.0, 0.0)))};
  push(d, Vec3(50.0, 0.0, 0.0), Vec3(-50e3, 0.0, 0.0));
  rest = solve_lines(build_model(d));
  ASSERT_TRUE(rest.failure);
  EXPECT_NE(rest.failure->what.find("yaw"), std::string::npos) << rest.failure->what;
}

TEST(lines_on_a_moored_vessel, are_rejected) {
  Description d = hull_afloat();
  d.moorings.emplace().lines.emplace_back();
  d.lines = {wire("hawser", 210.0, on_body("vessel", Vec3(50.0, 0.0, 0.0)), fixed(Vec3(250.0, 0.0, 0.0)))};
  const ModelEquilibrium rest = solve_lines(build_model(d));
  ASSERT_TRUE(rest.failure);
  EXPECT_EQ(rest.failure->key, "lines");
}

}  // namespace
}  // namespace overbend
