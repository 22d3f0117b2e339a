#include "model/lay_route.h"

#include <gtest/gtest.h>

#include "support/fixtures.h"

namespace overbend {
namespace {

TEST(lay_route, a_straight_route_keeps_direction_and_has_no_curvature) {
  const LayRoute route(Vec3(1.0, 2.0, 3.0), Vec3(0.6, 0.8, 0.0));
  EXPECT_LT((route.place(10.0) - Vec3(7.0, 10.0, 3.0)).norm(), 1e-14);
  EXPECT_EQ(route.direction(0.0), route.direction(500.0));
  EXPECT_EQ(route.curvature(250.0), 0.0);
}

TEST(lay_route, a_place_on_it_is_found_again_and_one_beside_it_is_as_far_off_as_it_is) {
  const LayRoute route(Vec3(1.0, 2.0, 3.0), Vec3(0.6, 0.8, 0.0));
  const Vec3 beside = route.place(120.0) + 4.0 * route.port(120.0) - Vec3(0.0, 0.0, 60.0);
  EXPECT_NEAR(route.distance(beside), 120.0, 1e-12);
  EXPECT_NEAR(route.offset(beside), 4.0, 1e-12);
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

}  // namespace
}  // namespace overbend
