// The sea bed under a vessel that moves ahead.
#include <gtest/gtest.h>

#include "support/fixtures.h"

namespace overbend {
namespace {

TEST(moved_bed, stays_behind_as_far_as_the_vessel_goes_ahead) {
  Description profile = testing::plain_description();
  profile.environment.seabed.profile = {{0.0, 89.0}, {50.0, 90.0}, {80.0, 88.0}, {200.0, 89.0}};
  Description area = testing::plain_description();
  area.environment.seabed.bathymetry = testing::hummocks();
  for (const Description& d : {profile, area}) {
    Description later = d;
    later.stage = LayStageDescription{};
    later.stage->ahead = 12.5;
    const Model before = build_model(d), after = build_model(later);
    for (const Vec3& p : {Vec3(-120.0, 3.0, 0.0), Vec3(4.0, 0.5, 0.0), Vec3(-3.0, 2.0, 0.0)}) {
      const Vec3 moved = p + 12.5 * astern_direction(before.mean_pose);
      EXPECT_NEAR(after.seabed.surface.height(moved.x(), moved.y()), before.seabed.surface.height(p.x(), p.y()), 1e-9);
    }
  }
}

}  // namespace
}  // namespace overbend
