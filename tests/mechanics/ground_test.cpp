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
  const BedSurface& bed = model.seabed.surface;
  const LineEnvironment env = line_environment(model, route);
  for (const Vec3& r : {Vec3(-150.0, 3.0, -88.0), Vec3(400.0, -70.0, -95.0)}) {
    const GroundPoint at = ground_at(env, r);
    const double s = route.distance(r);
    EXPECT_EQ(at.normal, bed.normal(r.x(), r.y()));
    EXPECT_EQ(at.clearance, bed.clearance(r));
    EXPECT_EQ(at.across_route, route.port(s));
    EXPECT_EQ(at.off_route, route.offset(r));
    EXPECT_EQ(at.along_route, bed.along(r, route.direction(s)));
  }
}

}  // namespace
}  // namespace overbend
