#include "statics/solver/anchored_lay.h"

#include <gtest/gtest.h>

#include "base/constants.h"
#include "modelfile/reading/yaml_reader.h"
#include "statics/recovery/recovery.h"
#include "statics/recovery/recovery_target.h"

namespace overbend {
namespace {

Description read(const std::string& text) {
  return read_model_text(text, "lay.yaml").description.value();
}

/// A pipe of 219.1 x 12.7 mm from a guide at the surface to the bed in 100 m of water.
const std::string kJlay = R"(
overbend: 1
environment: {water_depth: 100 m, seabed: {stiffness: 100 kN/m^2}}
pipe:
  steel: {outside_diameter: 219.1 mm, wall_thickness: 12.7 mm, yield_stress: 450 MPa}
vessel: {stern_shoe: {x: -60 m, z: 0 m}}
tensioner: {x: 0 m, z: 0 m, guide: pinned, tension: 60 kN}
)";

/// A pipe over seven rollers.
const std::string kSlay = R"(
overbend: 1
environment: {water_depth: 300 m, seabed: {stiffness: 100 kN/m^2}}
pipe:
  steel: {outside_diameter: 406.4 mm, wall_thickness: 12.7 mm, yield_stress: 450 MPa}
  coatings: [{name: concrete, thickness: 50 mm, weight_density: 30 kN/m^3}]
vessel: {stern_shoe: {x: -60 m, z: 0 m}}
tensioner: {x: -30 m, z: 6 m, tension: 761.34 kN}
rollers: {plain: {bottom: {radius: 0.15 m, face: 1 m}}}
supports:
  ramp: {roller: plain, boxes: [{x: -20 m, z: 5.8 m}, {x: -10 m, z: 5.5 m}]}
  stinger: {roller: plain, radius: 100 m, boxes: {count: 5, spacing: 8 m}}
)";

Description with_structure(Description d, const StructureDescription& structure) {
  d.pipe.structures.push_back(structure);
  return d;
}

StructureDescription buoy(double from_top, double length, double weight_submerged) {
  StructureDescription structure;
  structure.name = "buoy";
  structure.at = from_top;
  structure.length = length;
  structure.weight_in_air = 20e3;
  structure.weight_submerged = weight_submerged;
  return structure;
}

StaticResults solve(const Description& d) {
  const Model model = build_model(d);
  const StaticOutcome outcome = solve_statics(model);
  EXPECT_TRUE(outcome.solution) << outcome.failure->what << ": " << outcome.failure->why;
  return outcome.solution ? recover_statics(model, *outcome.solution) : StaticResults{};
}

/// The lay with the length and the anchor that a given tension leads to, in place of that tension.
Description anchored(Description d, const StaticResults& pulled) {
  d.tensioner.tension.reset();
  d.pipe.length = pulled.total_length;
  d.pipe.anchor = pulled.stations.front().astern;
  return d;
}

/// 10 mm of length change the tension of such lines by some per cent; both meshes place the far end to 0.1 mm.
void expect_that_length_and_anchor_give_back_the_tension(Description d, double tension) {
  d.tensioner.tension = tension;
  const StaticResults pulled = solve(d), found = solve(anchored(d, pulled));
  EXPECT_NEAR(found.top_tension / pulled.top_tension, 1.0, 2e-3);
  EXPECT_NEAR(found.lay_back, pulled.lay_back, 1e-3 * pulled.lay_back);
}

StaticFailure rejection(const Description& d) {
  const StaticOutcome outcome = solve_statics(build_model(d));
  EXPECT_FALSE(outcome.solution);
  return outcome.failure.value_or(StaticFailure{});
}

}  // namespace

TEST(anchored_lay, buoys_on_the_way_down_do_not_hide_the_tension) {
  expect_that_length_and_anchor_give_back_the_tension(with_structure(read(kJlay), buoy(50.0, 5.0, -2e3)), 60e3);
}

TEST(anchored_lay, lazy_waves_of_given_length_lie_as_with_their_tension) {
  Description d = with_structure(read(kJlay), buoy(150.0, 40.0, -40e3));
  d.tensioner.tension = 25e3;
  const StaticResults wave = solve(d);
  double lowest = 0.0, rise = 0.0;  // from the tensioner down
  for (auto station = wave.stations.rbegin(); station != wave.stations.rend(); ++station) {
    lowest = std::min(lowest, station->p_W.z());
    rise = std::max(rise, station->p_W.z() - lowest);
  }
  EXPECT_GT(rise, 5.0);
  expect_that_length_and_anchor_give_back_the_tension(d, 25e3);
}

TEST(anchored_lay, a_side_current_lays_the_pipe_next_to_its_route_whether_the_tension_is_given_or_follows) {
  Description d = read(kSlay);
  d.environment.seabed.friction_lateral = 0.5;
  d.environment.current = {{0.0, 0.4, 0.25 * kTurn}, {300.0, 0.1, 0.25 * kTurn}};
  expect_that_length_and_anchor_give_back_the_tension(d, 900e3);
}

TEST(anchored_lay, the_pipe_lies_on_its_rollers_where_another_equilibrium_has_it_below_them) {
  const StaticResults pulled = solve(read(kSlay));
  Description d = read(kSlay);
  d.tensioner.tension.reset();
  d.pipe.length = 783.527308;
  d.pipe.anchor = 624.270121;
  const StaticResults found = solve(d);
  // The same line with this tension lies on its rollers; below them it would be in balance with 728 kN.
  EXPECT_NEAR(found.top_tension, 761.34e3, 1e3);
  EXPECT_NEAR(found.lay_back, pulled.lay_back, 0.2);
  for (const SupportResult& support : found.supports) EXPECT_GT(support.separation, -0.02) << support.name;
}

TEST(anchored_lay, an_anchor_that_is_too_near_or_too_far_is_rejected_with_the_distances_that_are_possible) {
  Description d = read(kJlay);
  d.tensioner.tension.reset();
  d.pipe.length = 400.0;
  d.pipe.anchor = 280.0;  // nearer than a pipe that hangs plumb and lies straight from there
  EXPECT_EQ(rejection(d).what, "the anchor is too near");
  d.pipe.anchor = 399.0;  // sqrt(400^2 - 100^2) = 387 m is all that a straight line would reach
  EXPECT_EQ(rejection(d).what, "the anchor is too far");
}

TEST(anchored_lay, the_derivative_of_the_tension_by_the_distance_is_that_of_neighbouring_lays) {
  Description d = read(kJlay);
  d.tensioner.tension.reset();
  d.pipe.length = 300.0;
  d.pipe.anchor = 250.0;
  const Model model = build_model(d);
  const StaticOutcome outcome = solve_statics(model);
  const auto tension = [&](double distance) {
    Description moved = d;
    moved.pipe.anchor = distance;
    const Model moved_model = build_model(moved);
    return recover_statics(moved_model, *solve_statics(moved_model, &*outcome.solution).solution).top_tension;
  };
  const double step = 1e-3, difference = (tension(250.0 + step) - tension(250.0 - step)) / (2.0 * step);
  EXPECT_NEAR(*tension_per_anchor_distance(model, *outcome.solution) / difference, 1.0, 1e-3);
}

}  // namespace overbend
