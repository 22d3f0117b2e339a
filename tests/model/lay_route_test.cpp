#include "model/lay_route.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/constants.h"
#include "support/fixtures.h"

namespace overbend {
namespace {

TEST(lay_route, a_straight_route_keeps_direction_and_has_no_curvature) {
  const LayRoute route(Vec3(1.0, 2.0, 3.0), Vec3(0.6, 0.8, 0.0));
  EXPECT_LT((route.place(10.0) - Vec3(7.0, 10.0, 3.0)).norm(), 1e-14);
  EXPECT_EQ(route.direction(0.0), route.direction(500.0));
  EXPECT_EQ(route.curvature(250.0), 0.0);
}

TEST(lay_route, a_place_on_it_is_found_again_and_one_next_to_it_is_as_far_off_as_it_is) {
  const LayRoute route(Vec3(1.0, 2.0, 3.0), Vec3(0.6, 0.8, 0.0));
  const Vec3 neighbour = route.place(120.0) + 4.0 * route.port(120.0) - Vec3(0.0, 0.0, 60.0);
  EXPECT_NEAR(route.distance(neighbour), 120.0, 1e-12);
  EXPECT_NEAR(route.offset(neighbour), 4.0, 1e-12);
}

TEST(lay_route, starts_at_the_tensioner_and_runs_astern_with_port_as_the_barge_has_it) {
  Description d = testing::plain_description();
  d.vessel.heading = 0.7;
  d.tensioner.x = -20.0;
  const Model model = build_model(d);
  const LayRoute route = lay_route(model);
  const TensionerDescription& tensioner = model.description.tensioner;
  EXPECT_EQ(route.place(0.0), point_from_ramp(model, model.mean_pose, Vec3(tensioner.x, 0.0, tensioner.z)));
  EXPECT_LT((route.direction(0.0) + model.mean_pose.R_WV.col(0)).norm(), 1e-12);
  EXPECT_LT((route.port(0.0) - model.mean_pose.R_WV.col(1)).norm(), 1e-12);
}

/// 50 m straight, an arc of 200 m by 60 degrees to port, 30 m straight, an arc of 100 m by 40 degrees to starboard.
LayRoute bent_route() {
  return {Vec3(1.0, 2.0, 3.0),
          Vec3(0.6, 0.8, 0.0),
          20.0,
          {{30.0, 0.0, 0.0}, {0.0, 200.0, kPi / 3.0}, {30.0, 0.0, 0.0}, {0.0, 100.0, -2.0 * kPi / 9.0}}};
}

TEST(lay_route, an_arc_ends_where_geometry_has_it_and_turned_by_its_angle) {
  const LayRoute route = bent_route();
  const Vec3 t(0.6, 0.8, 0.0), port(0.8, -0.6, 0.0);
  const double end = 50.0 + 200.0 * kPi / 3.0;
  const Vec3 expected = Vec3(1.0, 2.0, 3.0) + 50.0 * t + 200.0 * (std::sqrt(3.0) / 2.0 * t + 0.5 * port);
  EXPECT_LT((route.place(end) - expected).norm(), 1e-10);
  EXPECT_LT((route.direction(end) - (0.5 * t + std::sqrt(3.0) / 2.0 * port)).norm(), 1e-12);
  EXPECT_EQ(route.curvature(60.0), 1.0 / 200.0);
  EXPECT_EQ(route.curvature(end + 31.0), -1.0 / 100.0);
  EXPECT_EQ(route.curvature(10.0), 0.0);
  EXPECT_EQ(route.curvature(1e4), 0.0);
  EXPECT_EQ(route.max_curvature_beyond(0.0), 1.0 / 100.0);
  EXPECT_EQ(route.max_curvature_beyond(1e4), 0.0);
}

TEST(lay_route, is_one_smooth_line_whose_length_is_s) {
  const LayRoute route = bent_route();
  for (double s = -10.0; s < 420.0; s += 3.7) {
    const double h = 1e-4;
    EXPECT_NEAR((route.place(s + h) - route.place(s - h)).norm(), 2.0 * h, 1e-10) << s;
    EXPECT_LT((route.place(s + h) - route.place(s) - h * route.direction(s)).norm(), 1e-10) << s;
    EXPECT_NEAR((route.direction(s + h) - route.direction(s)).dot(route.port(s)), h * route.curvature(s), 2e-6) << s;
  }
}

TEST(lay_route, of_arcs_finds_places_again_and_how_far_off_they_are) {
  const LayRoute route = bent_route(), parallel_route = route.parallel_route(1.5);
  for (double s = 1.0; s < 420.0; s += 7.3) {
    for (const double off : {-6.0, 0.0, 6.0}) {
      const Vec3 p = route.place(s) + off * route.port(s) - Vec3(0.0, 0.0, 60.0);
      EXPECT_NEAR(route.distance(p), s, 1e-9);
      EXPECT_NEAR(route.offset(p), off, 1e-9);
      EXPECT_NEAR(parallel_route.offset(p), off - 1.5, 1e-9);
    }
  }
}

TEST(lay_route, points_are_rounded_between_straight_lines_through_them) {
  RouteDescription given;
  given.points = {{400.0, 0.0}, {900.0, 200.0}, {1500.0, 0.0}};
  const LayRoute route(Vec3::Zero(), Vec3::UnitX(), 0.0, route_legs(given, 300.0));
  const Vec3 first(400.0, 0.0, 0.0), second(900.0, -200.0, 0.0);  // y to port of one who looks astern is -y
  const double turn = std::atan2(200.0, 500.0);
  const double past = 300.0 * (1.0 / std::cos(0.5 * turn) - 1.0);  // of the arc from the corner
  EXPECT_NEAR(std::abs(route.offset(first)), past, 1e-9);
  const Vec3 between = 0.5 * (first + second);
  EXPECT_NEAR(route.offset(between), 0.0, 1e-9);
  EXPECT_NEAR(route.offset(Vec3(1500.0, 0.0, 0.0)), 0.0, 1e-9);
}

TEST(lay_route, corners_without_a_radius_get_the_least_that_friction_holds_and_half_as_much) {
  Description d = testing::plain_description();
  d.environment.seabed.friction_lateral = 0.5;
  d.route.points = {{2000.0, 0.0}, {6000.0, 1000.0}, {9000.0, 1000.0}};
  const Model model = build_model(d);
  const double suspended_weight = model.sections[0].weight_submerged * 89.0;
  EXPECT_NEAR(default_corner_radius(model),
              1.5 * (250e3 - suspended_weight) / (0.5 * model.sections[0].weight_submerged), 1.0);
}

}  // namespace
}  // namespace overbend
