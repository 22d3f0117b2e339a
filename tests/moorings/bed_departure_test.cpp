#include "moorings/bed_departure.h"

#include <gtest/gtest.h>

#include <array>

#include "model/site/seabed_shape.h"

namespace overbend {
namespace {

/// 89 m deep along x, with what stands or gapes at 600 m, 50 m to each side.
SeabedSurface bed_with(double depth_at_600) {
  constexpr std::array<double, 2> kOrigin = {0.0, 0.0}, kAlong = {1.0, 0.0};
  return {profile_shape({{0.0, 89.0}, {550.0, 89.0}, {600.0, depth_at_600}, {650.0, 89.0}, {1000.0, 89.0}},
                        kOrigin.data(), kAlong.data()),
          -89.0};
}

/// Hangs from 4 m above the water to 400 m, lies from there to its anchor at 900 m.
std::vector<Vec3> line() {
  std::vector<Vec3> shape;
  for (int i = 0; i <= 40; ++i) {
    const double share = 1.0 - i / 40.0;
    shape.emplace_back(10.0 * i, 7.0, -89.0 + 93.0 * share * share);
  }
  shape.emplace_back(900.0, 7.0, -89.0);  // one stretch on the bed
  return shape;
}

TEST(bed_departure, finds_a_ridge_under_what_lies_between_two_points) {
  const BedDeparture departure = bed_departure(bed_with(79.0), line());
  EXPECT_NEAR(departure.inside, 10.0, 0.5);  // looked for every two metres, of a bed that rises one in five
  EXPECT_NEAR(departure.inside_at, 300.0, 2.0);
  EXPECT_LT(departure.over_hollow, 0.5);
}

TEST(bed_departure, finds_a_hollow_under_what_lies_and_none_under_what_is_suspended) {
  const BedDeparture departure = bed_departure(bed_with(95.0), line());
  EXPECT_NEAR(departure.over_hollow, 6.0, 0.3);
  EXPECT_NEAR(departure.hollow_at, 300.0, 2.0);
  std::vector<Vec3> suspended = line();
  for (Vec3& p : suspended) p.z() += 0.1 * (900.0 - p.x());  // over the whole way
  EXPECT_EQ(bed_departure(bed_with(95.0), suspended).over_hollow, 0.0);
}

TEST(bed_departure, of_a_plane_is_none) {
  EXPECT_EQ(bed_departure(SeabedSurface(Vec3(0.0, 0.0, -70.0), Vec3::UnitZ()), line()).inside, 0.0);
}

}  // namespace
}  // namespace overbend
