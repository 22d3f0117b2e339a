#include "model/site/seabed_surface.h"

#include <gtest/gtest.h>

#include <cmath>

namespace overbend {
namespace {

/// Falls by 5 in 100 to the east and rises by 2 in 100 to the north, 80 m deep at (10, 20).
SeabedSurface tilted() {
  return {Vec3(10.0, 20.0, -80.0), Vec3(0.05, -0.02, 1.0).normalized()};
}

TEST(bed_surface, is_as_high_as_its_plane_everywhere) {
  EXPECT_NEAR(tilted().height(10.0, 20.0), -80.0, 1e-12);
  EXPECT_NEAR(tilted().height(110.0, 70.0), -80.0 - 5.0 + 1.0, 1e-12);
}

TEST(bed_surface, a_point_on_it_has_no_clearance_and_one_next_to_it_its_distance) {
  const SeabedSurface bed = tilted();
  const Vec3 on(-300.0, 400.0, bed.height(-300.0, 400.0));
  EXPECT_NEAR(bed.clearance(on), 0.0, 1e-12);
  EXPECT_NEAR(bed.clearance(on + 0.3 * bed.normal(-300.0, 400.0)), 0.3, 1e-12);
  EXPECT_NEAR(bed.clearance(on + Vec3(0.0, 0.0, -0.5)), -0.5 * bed.normal(0.0, 0.0).z(), 1e-12);
}

TEST(bed_surface, its_slope_is_the_derivative_of_its_height) {
  const SeabedSurface bed = tilted();
  const Vec3 direction = Vec3(0.6, 0.8, 0.0);
  const double rise = bed.height(5.0 + 0.6, 7.0 + 0.8) - bed.height(5.0, 7.0);  // a metre on a plane
  EXPECT_NEAR(bed.slope(5.0, 7.0, direction), rise, 1e-12);
}

TEST(bed_surface, a_direction_along_it_stays_on_it) {
  const SeabedSurface bed = tilted();
  const Vec3 on(3.0, 4.0, bed.height(3.0, 4.0));
  const Vec3 along = bed.along(on, Vec3::UnitX());
  EXPECT_NEAR(along.norm(), 1.0, 1e-15);
  EXPECT_NEAR(bed.clearance(on + 50.0 * along), 0.0, 1e-12);
}

TEST(bed_surface, is_level_at_the_water_unless_prescribed) {
  EXPECT_EQ(SeabedSurface().height(1.0, 2.0), 0.0);
  EXPECT_EQ(SeabedSurface().normal(1.0, 2.0), Vec3::UnitZ());
}

}  // namespace
}  // namespace overbend
