#include "model/box_dip.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/constants.h"

namespace overbend {
namespace {

SupportBox inclined(double dip) {
  SupportBox box;
  box.inclination = dip;
  box.direction_S = Vec3(std::cos(dip), 0.0, -std::sin(dip));
  return box;
}

VesselPose pose(double heading, double trim, double heel) {
  return {Vec3::Zero(), vessel_axes(heading, trim, heel)};
}

TEST(box_dip, on_even_keel_is_the_inclination_on_any_heading) {
  for (const double heading : {0.0, 1.0, 4.0}) EXPECT_NEAR(box_dip(pose(heading, 0.0, 0.0), inclined(0.3)), 0.3, 1e-12);
}

TEST(box_dip, grows_with_the_trim_that_lowers_the_stern) {
  EXPECT_NEAR(box_dip(pose(1.0, 2.0 * kDegree, 0.0), inclined(0.3)), 0.3 + 2.0 * kDegree, 1e-12);
  EXPECT_NEAR(box_dip(pose(1.0, -2.0 * kDegree, 0.0), inclined(-0.1)), -0.1 - 2.0 * kDegree, 1e-12);
}

TEST(box_dip, of_a_heeled_vessel_is_that_of_the_box_axis_in_the_world) {
  EXPECT_NEAR(box_dip(pose(0.5, 0.0, 0.2), inclined(0.3)), std::asin(std::sin(0.3) * std::cos(0.2)), 1e-12);
}

}  // namespace
}  // namespace overbend
