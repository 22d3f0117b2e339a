#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "model/lay_route.h"
#include "statics/recovery/recovery.h"
#include "statics/solver/statics.h"
#include "support/fixtures.h"

namespace overbend {
namespace {

/// J-lay of a soft pipe onto a route with an arc well behind touchdown, 115 m astern.
Description lay_on(double radius, double turn, double friction) {
  Description d = testing::plain_description();
  d.environment.seabed.friction_lateral = friction;
  d.pipe.section.steel.youngs_modulus = 4e9;
  d.tensioner.x = 0.0;
  d.tensioner.z = 0.5;
  d.tensioner.incline = 60.0 * kDegree;
  d.tensioner.guide = Guide::pinned;
  d.tensioner.tension = 80e3;
  d.route.legs = {{400.0, 0.0, 0.0}, {0.0, radius, turn}};
  return d;
}

struct Laid {
  Model model;
  StaticResults results;
};

Laid laid(const Description& description) {
  Laid lay{build_model(description), {}};
  const StaticOutcome outcome = solve_statics(lay.model);
  EXPECT_TRUE(outcome.solution) << (outcome.failure ? outcome.failure->why : "");
  if (outcome.solution) lay.results = recover_statics(lay.model, *outcome.solution);
  return lay;
}

/// Offset of the pipe from its route near a distance along it.
double offset_at(const Laid& lay, double s) {
  const LayRoute route = lay_route(lay.model);
  double nearest = 1e30, offset = 0.0;
  for (const Station& station : lay.results.stations) {
    const double away = std::abs(route.distance(station.p_W) - s);
    if (away < nearest) {
      nearest = away;
      offset = route.offset(station.p_W);
    }
  }
  return offset;
}

TEST(curved_route, least_radius_is_that_of_bottom_tension_weight_and_friction) {
  const Laid lay = laid(lay_on(800.0, 20.0 * kDegree, 0.5));
  ASSERT_TRUE(lay.results.route);
  EXPECT_DOUBLE_EQ(lay.results.route->min_stable_radius,
                   lay.results.bottom_tension / (0.5 * lay.model.sections[0].weight_submerged));
  EXPECT_NEAR(lay.results.route->radius, 800.0, 1e-9);
  EXPECT_TRUE(lay.results.route->holds);
}

TEST(curved_route, an_arc_that_holds_stretches_the_friction_by_the_pull_of_the_string) {
  for (const double side : {1.0, -1.0}) {
    const Laid lay = laid(lay_on(800.0, side * 20.0 * kDegree, 0.5));
    ASSERT_TRUE(lay.results.route);
    const double pull = lay.results.bottom_tension / 800.0;  // per length, to the inside
    const double middle = 400.0 + 0.5 * 800.0 * 20.0 * kDegree;
    EXPECT_NEAR(offset_at(lay, middle), side * pull / 100e3, 0.005 * pull / 100e3);
    EXPECT_EQ(lay.results.route->slid_length, 0.0);
  }
}

/// If friction does not hold the bend, all of the pull is up against it: the pipe reaches equilibrium with the radius
/// H / (mu w), tangent to the straight lines on either side.
TEST(curved_route, an_arc_that_does_not_hold_slides_to_the_radius_that_does) {
  const double turn = 20.0 * kDegree, radius = 300.0, friction = 0.2;
  const Laid lay = laid(lay_on(radius, turn, friction));
  ASSERT_TRUE(lay.results.route);
  const RouteResults& route = *lay.results.route;
  EXPECT_FALSE(route.holds);
  const double found = route.min_stable_radius;
  ASSERT_GT(found, 1.2 * radius);
  // A beam with lambda^2 = EI/H under H y'' - EI y'''' = f, |f| <= mu w, straight and without moment beyond: f turns
  // its sign lambda ln 2 before the end and adds (1 - ln^2 2) lambda^2/R in the middle. The bed holds across the route,
  // to which the pipe lies at up to 5 degrees: that pulls along it by up to 1 % of H and leaves 2 % of the offset.
  const double lambda = std::sqrt(lay.model.sections[0].EI / lay.results.bottom_tension), ln2 = std::log(2.0);
  const double string = (found - radius) * (1.0 / std::cos(0.5 * turn) - 1.0);
  const double beam = string + (1.0 - ln2 * ln2) * lambda * lambda / found;
  EXPECT_NEAR(route.max_offset, beam, 0.025 * beam);
  EXPECT_GT(route.slid_length, found * turn);  // at its ends it slides by less than the bed's elastic stretch
  EXPECT_LT(route.slid_length, found * turn + 4.0 * lambda * ln2);
  EXPECT_NEAR(offset_at(lay, 400.0 + 0.5 * radius * turn), route.max_offset, 0.02);
}

TEST(curved_route, without_friction_the_pipe_leaves_the_bend_for_its_chord) {
  const Laid held = laid(lay_on(300.0, 20.0 * kDegree, 0.5)), loose = laid(lay_on(300.0, 20.0 * kDegree, 0.02));
  ASSERT_TRUE(held.results.route && loose.results.route);
  EXPECT_FALSE(loose.results.route->holds);
  EXPECT_GT(loose.results.route->max_offset, 20.0 * std::abs(held.results.route->max_offset));
  EXPECT_TRUE(std::ranges::any_of(messages(loose.results.findings), [](const std::string& warning) {
    return warning.find("the route does not hold") != std::string::npos;
  }));
}

TEST(curved_route, to_starboard_is_the_mirror_image) {
  const Laid port = laid(lay_on(300.0, 20.0 * kDegree, 0.2)), starboard = laid(lay_on(300.0, -20.0 * kDegree, 0.2));
  ASSERT_TRUE(port.results.route && starboard.results.route);
  EXPECT_NEAR(port.results.route->max_offset, -starboard.results.route->max_offset, 1e-6);
}

}  // namespace
}  // namespace overbend
