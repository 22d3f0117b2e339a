#include "mechanics/ground.h"

#include <gtest/gtest.h>

#include "mechanics/line_elements.h"
#include "support/fixtures.h"

namespace overbend {
namespace {

TEST(ground, is_the_bed_and_the_route_of_the_model_at_every_place) {
  Description d = testing::plain_description();
  d.vessel.heading = 0.7;
  d.environment.seabed.slope = 0.05;
  d.environment.seabed.slope_towards = 1.0;
  const Model model = build_model(d);
  const LayRoute route = lay_route(model);
  const SeabedSurface& bed = model.seabed.surface;
  const LineEnvironment env = line_environment(model, route);
  for (const Vec3& r : {Vec3(-150.0, 3.0, -88.0), Vec3(400.0, -70.0, -95.0)}) {
    const GroundPoint ground_point = ground_at(env, r);
    const double s = route.distance(r);
    EXPECT_EQ(ground_point.normal, bed.normal(r.x(), r.y()));
    EXPECT_EQ(ground_point.clearance, bed.clearance(r));
    EXPECT_EQ(ground_point.clearance, bed_clearance(env, r));
    EXPECT_EQ(ground_point.across_route, route.port(s));
    EXPECT_EQ(ground_point.off_route, route.offset(r));
    EXPECT_EQ(ground_point.along_route, bed.along(r, route.direction(s)));
  }
}

TEST(ground, of_a_shaped_bed_is_the_tangent_plane_under_the_place) {
  Description d = testing::plain_description();
  d.environment.seabed.bathymetry = testing::hummocks();
  const Model model = build_model(d);
  const SeabedSurface& bed = model.seabed.surface;
  const LineEnvironment env = line_environment(model, LayRoute(Vec3::Zero(), -Vec3::UnitX()));
  const Vec3 r(4.1, 0.7, -88.4);
  const GroundPoint ground_point = ground_at(env, r);
  EXPECT_NEAR(ground_point.clearance, bed.clearance(r), 1e-12);
  EXPECT_EQ(ground_point.clearance, bed_clearance(env, r));
  EXPECT_LT((ground_point.normal - bed.normal(r.x(), r.y())).norm(), 1e-12);
  EXPECT_LT((ground_point.along_route - bed.along(r, -Vec3::UnitX())).norm(), 1e-12);
  const double step = 1e-6;
  const Mat3 along_turn = along_route_turn(ground_point);
  for (int i = 0; i < 3; ++i) {
    const GroundPoint up = ground_at(env, r + step * Vec3::Unit(i)), down = ground_at(env, r - step * Vec3::Unit(i));
    EXPECT_NEAR(ground_point.gradient(i), (up.clearance - down.clearance) / (2.0 * step),
                1e-7);  // rounding of 89 m over the step
    EXPECT_LT((ground_point.turn.col(i) - (up.normal - down.normal) / (2.0 * step)).norm(), 1e-7);
    EXPECT_LT((along_turn.col(i) - (up.along_route - down.along_route) / (2.0 * step)).norm(), 1e-7);
  }
}

TEST(ground, rises_from_level_to_its_shape_as_its_relief_grows) {
  Description d = testing::plain_description();
  d.environment.seabed.bathymetry = testing::hummocks();
  const Model model = build_model(d);
  LineEnvironment env = line_environment(model, LayRoute(Vec3::Zero(), -Vec3::UnitX()));
  const Vec3 r(4.1, 0.7, -88.4);
  env.bed_level = -88.9;
  env.bed_relief = 0.0;
  EXPECT_DOUBLE_EQ(ground_at(env, r).clearance, 0.5);
  EXPECT_EQ(ground_at(env, r).normal, Vec3::UnitZ());
  env.bed_relief = 0.5;
  const double half = r.z() - 0.5 * (env.bed_level + model.seabed.surface.height(r.x(), r.y()));
  EXPECT_NEAR(ground_at(env, r).clearance, half * ground_at(env, r).normal.z(), 1e-12);
}

TEST(ground, is_the_bent_route_of_the_model_at_every_place) {
  Description d = testing::plain_description();
  d.vessel.heading = 0.7;
  d.environment.seabed.slope = 0.05;
  d.environment.seabed.slope_towards = 1.0;
  d.route.legs = {{100.0, 0.0, 0.0}, {0.0, 300.0, 0.8}, {50.0, 0.0, 0.0}, {0.0, 200.0, -1.0}};
  const Model model = build_model(d);
  const LayRoute route = lay_route(model).parallel_route(0.7);
  const LineEnvironment env = line_environment(model, route);
  for (double s = 5.0; s < 700.0; s += 40.0) {
    for (const double off : {-3.0, 4.0}) {
      const Vec3 r = route.place(s) + off * route.port(s) - Vec3(0.0, 0.0, 90.0);
      const GroundPoint ground_point = ground_at(env, r);
      EXPECT_NEAR(ground_point.off_route, off, 1e-9);
      EXPECT_LT((ground_point.across_route - route.port(s)).norm(), 1e-9);
      EXPECT_LT((ground_point.along_route - model.seabed.surface.along(r, route.direction(s))).norm(), 1e-9);
    }
  }
}

}  // namespace
}  // namespace overbend
