#include "moorings/suspended_line.h"

#include <gtest/gtest.h>

#include <cmath>

namespace overbend {
namespace {

CatenaryLine rope(double length) {
  CatenaryLine line;
  line.pieces = {{0.6 * length, 100.0, 80.0, 5e7, 0.0}, {0.4 * length, 150.0, 120.0, 8e7, 0.0}};
  return line;
}

// The supports of the ends carry the weight of the line, and both pull the same way level.
TEST(suspended_line, is_borne_by_its_two_ends) {
  const Vec3 first(10.0, -5.0, 60.0), second(40.0, 20.0, 25.0);
  const SuspendedLineForces forces = suspended_line_forces(rope(60.0), first, second);
  ASSERT_TRUE(forces.found);
  const Vec3 sum = forces.on_first + forces.on_second;
  EXPECT_NEAR(sum.z(), -(36.0 * 100.0 + 24.0 * 150.0), 1e-3);
  EXPECT_NEAR(sum.head<2>().norm(), 0.0, 1e-6);
}

TEST(suspended_line, pulls_alike_written_from_either_end) {
  const Vec3 first(0.0, 0.0, -30.0), second(25.0, 10.0, 15.0);
  CatenaryLine turned = rope(60.0);
  std::swap(turned.pieces[0], turned.pieces[1]);
  const SuspendedLineForces a = suspended_line_forces(rope(60.0), first, second),
                            b = suspended_line_forces(turned, second, first);
  ASSERT_TRUE(a.found && b.found);
  EXPECT_NEAR((a.on_first - b.on_second).norm(), 0.0, 1e-6);
}

TEST(suspended_line, has_the_stiffness_of_its_differences) {
  constexpr double kStep = 1e-4;
  const CatenaryLine line = rope(60.0);
  for (const bool rises : {false, true}) {
    const Vec3 first(0.0, 0.0, rises ? -60.0 : -10.0), second(25.0, 10.0, rises ? -10.0 : -60.0);
    const SuspendedLineForces local = suspended_line_forces(line, first, second);
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 step = kStep * Vec3::Unit(axis);
      const Vec3 slope = (suspended_line_forces(line, first, second + step).on_first -
                          suspended_line_forces(line, first, second - step).on_first) /
                         (2.0 * kStep);
      EXPECT_NEAR((local.stiffness.col(axis) - slope).norm(), 0.0, 1e-3 * slope.norm() + 0.1);
    }
  }
}

TEST(suspended_line, that_is_far_too_short_is_reported) {
  EXPECT_FALSE(suspended_line_forces(rope(20.0), Vec3::Zero(), Vec3(100.0, 0.0, -50.0)).found);
}

}  // namespace
}  // namespace overbend
