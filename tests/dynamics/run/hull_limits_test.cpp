#include "dynamics/run/hull_limits.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/free_body.h"

namespace overbend {
namespace {

using namespace testing;

TEST(hull_limits, end_a_run_whose_hull_pitches_beyond_sixty_degrees) {
  System system = rod_system({1e6, 1.0, 1.0}, 4.0, 2);
  system.bodies[0].free = free_body(SpringBody{});
  SystemState state = state_at_rest(system, {straight(system, Vec3::Zero(), Vec3::UnitX())}, 12.5);
  HullState& hull = state.bodies[0];
  hull.h(4) = 1.04;  // 59.6 deg
  hull.h(5) = 20.0;  // yaw has no limit
  EXPECT_FALSE(hull_failure(system, state));
  hull.h(4) = -1.05;
  const std::optional<StaticFailure> failure = hull_failure(system, state);
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->where, "at t = 12.50 s");
  EXPECT_EQ(failure->why, "the hull pitches beyond 60 deg");
  system.bodies[0].free.reset();  // its motion is prescribed
  EXPECT_FALSE(hull_failure(system, state));
}

TEST(hull_limits, end_a_run_whose_hull_moves_to_infinity) {
  System system = rod_system({1e6, 1.0, 1.0}, 4.0, 2);
  system.bodies[0].free = free_body(SpringBody{});
  SystemState state = state_at_rest(system, {straight(system, Vec3::Zero(), Vec3::UnitX())}, 0.0);
  state.bodies[0].v(0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(hull_failure(system, state));
}

}  // namespace
}  // namespace overbend
