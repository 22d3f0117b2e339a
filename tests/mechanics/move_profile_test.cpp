#include "mechanics/move_profile.h"

#include <gtest/gtest.h>

#include <cmath>

namespace overbend {
namespace {

MoveProfile make_profile(MoveShape shape) {
  MoveProfile profile;
  profile.shape = shape;
  profile.distance = 12.0;
  profile.start = 5.0;
  profile.wait = 20.0;
  profile.moves = 3;
  profile.period = 66.9;
  return profile;
}

TEST(move_profile, of_twelve_metres_takes_the_way_over_the_speed_and_a_ramp) {
  MoveProfile profile = make_profile(MoveShape::trapezoid);
  for (const auto& [speed, ramp, duration] : {std::array{0.10, 10.0, 130.0}, std::array{0.15, 10.0, 90.0},
                                              std::array{0.20, 10.0, 70.0}, std::array{0.15, 30.0, 110.0}}) {
    profile.speed = speed;
    profile.ramp = ramp;
    EXPECT_NEAR(profile.duration(), duration, 1e-12);
  }
}

TEST(move_profile, goes_the_whole_way_and_its_rates_are_those_of_its_differences) {
  for (const MoveShape shape : {MoveShape::trapezoid, MoveShape::minimum_jerk, MoveShape::zero_vibration}) {
    const MoveProfile profile = make_profile(shape);
    EXPECT_EQ(profile.at(profile.start).distance, 0.0);
    EXPECT_NEAR(profile.at(profile.end()).distance, 36.0, 1e-12);
    EXPECT_NEAR(profile.at(profile.end() + 1e4).distance, 36.0, 1e-12);
    EXPECT_NEAR(profile.at(profile.start + profile.duration() + 0.5 * profile.wait).distance, 12.0, 1e-12);
    constexpr double kStep = 1e-3;
    double max_value = 0.0;
    for (double t = 0.0; t < profile.end() + 10.0; t += 0.7) {
      const double speed = (profile.at(t + kStep).distance - profile.at(t - kStep).distance) / (2.0 * kStep);
      EXPECT_NEAR(profile.at(t).speed, speed, 1e-5) << t;  // a ramp of 0.015 m/s2 that begins within a step
      max_value = std::max(max_value, profile.at(t).speed);
    }
    EXPECT_LE(max_value, 0.15 + 1e-12);
    EXPECT_GT(max_value, 0.149);
  }
}

TEST(move_profile, that_is_too_short_for_its_speed_turns_back_halfway) {
  MoveProfile profile = make_profile(MoveShape::trapezoid);
  profile.distance = -0.6;
  profile.moves = 1;
  EXPECT_NEAR(profile.duration(), 2.0 * std::sqrt(0.6 / 0.015), 1e-12);
  EXPECT_NEAR(profile.at(5.0 + 0.5 * profile.duration()).distance, -0.3, 1e-12);
  EXPECT_NEAR(profile.at(profile.end()).distance, -0.6, 1e-12);
}

/// Singer and Seering (1990): the second half cancels what the first has begun.
TEST(move_profile, in_two_parts_leaves_an_undamped_pendulum_at_rest) {
  MoveProfile profile = make_profile(MoveShape::zero_vibration);
  profile.moves = 1;
  const double omega = 2.0 * 3.14159265358979323846 / profile.period;
  const auto left_by = [&](const MoveProfile& p) {
    double x = 0.0, v = 0.0;
    constexpr double kStep = 0.01;
    double max_value = 0.0;
    for (double t = 0.0; t < p.end() + p.period; t += kStep) {
      v += kStep * omega * omega * (p.at(t).distance - x);  // symplectic Euler
      x += kStep * v;
      if (t > p.end()) max_value = std::max(max_value, std::abs(x - p.distance));
    }
    return max_value;
  };
  EXPECT_LT(left_by(profile), 5e-3);
  profile.shape = MoveShape::trapezoid;
  EXPECT_GT(left_by(profile), 1.0);
}

}  // namespace
}  // namespace overbend
