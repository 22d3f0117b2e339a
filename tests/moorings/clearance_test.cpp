#include "moorings/clearance.h"

#include <gtest/gtest.h>

#include <cmath>

namespace overbend {
namespace {

TEST(clearance, of_crossing_parallel_and_end_to_end_stretches_is_the_plain_one) {
  const Vec3 o = Vec3::Zero(), x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
  EXPECT_NEAR(segment_distance(-x, x, -y + 0.5 * z, y + 0.5 * z), 0.5, 1e-15);  // crossing
  EXPECT_NEAR(segment_distance(o, x, 2.0 * y, x + 2.0 * y), 2.0, 1e-15);        // parallel
  EXPECT_NEAR(segment_distance(o, x, 3.0 * x, 4.0 * x), 2.0, 1e-15);            // in line
  EXPECT_NEAR(segment_distance(o, x, 2.0 * x + y, 2.0 * x + 3.0 * y), std::sqrt(2.0), 1e-15);
  EXPECT_NEAR(segment_distance(o, o, 3.0 * y, 3.0 * y), 3.0, 1e-15);  // two points
}

TEST(clearance, of_polylines_is_that_of_their_nearest_stretches) {
  const std::vector<Vec3> line = {{0, 0, 0}, {10, 0, -10}, {20, 0, -10}};
  EXPECT_NEAR(polyline_distance(line, {{15, -5, -12}, {15, 5, -12}}), 2.0, 1e-12);
  EXPECT_NEAR(polyline_distance(line, {{15, 3, -10}}), 3.0, 1e-12);
}

}  // namespace
}  // namespace overbend
