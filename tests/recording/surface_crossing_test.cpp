#include "recording/surface_crossing.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mechanics/line_kernel.h"

namespace overbend {
namespace {

/// Two nodes 2 m apart along x, inclined by `slope`, the middle at the surface; falling with 2 m/s.
LineState falling(double slope) {
  LineState state;
  const double c = std::cos(slope), s = std::sin(slope);
  for (const double side : {-1.0, 1.0}) {
    for (const double value : {side * c, 0.0, side * s, c, 0.0, s}) state.q.push_back(value);
    for (const double value : {0.0, 0.0, -2.0, 0.0, 0.0, 0.0}) state.v.push_back(value);
  }
  return state;
}

const LineMesh kMesh = {{10.0, 12.0}, {2.0}, {0}};

TEST(surface_crossing, is_the_speed_across_the_pipe_where_it_goes_through_the_surface) {
  SurfaceCrossing crossing;
  crossing.add(falling(0.3), 3.0, {}, kMesh);
  EXPECT_NEAR(crossing.speed(), 2.0 * std::cos(0.3), 1e-12);
  EXPECT_NEAR(crossing.s(), 11.0, 1e-12);
  EXPECT_EQ(crossing.time(), 3.0);
}

TEST(surface_crossing, counts_what_rises_towards_the_pipe_and_nothing_that_leaves_the_water) {
  std::vector<double> rising(2 * kWaterValues, 0.0);
  rising[2] = rising[kWaterValues + 2] = 0.5;
  SurfaceCrossing crossing;
  crossing.add(falling(0.3), 3.0, rising, kMesh);
  EXPECT_NEAR(crossing.speed(), 2.5 * std::cos(0.3), 1e-12);
  SurfaceCrossing leaving;
  LineState up = falling(0.3);
  up.v[2] = up.v[8] = 2.0;
  leaving.add(up, 3.0, {}, kMesh);
  EXPECT_EQ(leaving.speed(), 0.0);
  for (std::size_t node = 0; node < 2; ++node) rising[kWaterValues * node + 6] = 5.0;  // all under water
  leaving.add(falling(0.3), 3.0, rising, kMesh);
  EXPECT_EQ(leaving.speed(), 0.0);
}

TEST(surface_crossing, slams_the_example_pipe_with_1_3_kN_per_metre_at_1_m_per_s) {
  EXPECT_NEAR(slamming_force(1025.0, 0.489, 1.0), 1291.0, 1.0);
  EXPECT_NEAR(slamming_force(1025.0, 0.489, 2.0), 4.0 * 1291.0, 4.0);
}

}  // namespace
}  // namespace overbend
