#include "recording/vessel_recorder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/allocation_count.h"

namespace overbend {
namespace {

using Eigen::AngleAxisd;

Mat3 turned(double yaw, double pitch, double roll) {
  return (AngleAxisd(yaw, Vec3::UnitZ()) * AngleAxisd(pitch, Vec3::UnitY()) * AngleAxisd(roll, Vec3::UnitX()))
      .toRotationMatrix();
}

/// Bow to the north-west.
VesselPose drawn() {
  return {Vec3(10.0, -20.0, 0.0), turned(0.75 * std::numbers::pi, 0.0, 0.0)};
}

TEST(vessel_watch, shift_is_along_the_axes_of_the_pose_it_is_from) {
  const VesselPose from = drawn();
  const VesselPose to{from.p_WV + from.R_WV * Vec3(3.0, -1.0, 0.5), from.R_WV * turned(0.2, -0.03, 0.05)};
  const auto shift = shift_between(from, to);
  const std::array<double, 6> wanted = {3.0, -1.0, 0.5, 0.05, -0.03, 0.2};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(shift[i], wanted[i], 1e-12) << i;
}

// An ellipse of 2 m along and 1 m across, its long axis at 30 degrees to the bow, about a place 5 m ahead.
TEST(vessel_watch, statistics_of_an_elliptic_path) {
  constexpr int kSteps = 3600;
  constexpr double kTurn = std::numbers::pi / 6.0;
  const VesselPose home = drawn();
  VesselRecorder watch(home);
  const auto sample = [&](double u, double v) {
    return VesselPose{home.p_WV + home.R_WV * Vec3(u, v, 0.0), home.R_WV};
  };
  watch.start(sample(5.0, 0.0));
  watch.add(sample(50.0, 50.0), -1.0, 1.0);  // of the build-up: does not count
  const auto before = testing::allocation_count();
  for (int i = 1; i <= kSteps; ++i) {
    const double phase = 2.0 * std::numbers::pi * i / kSteps;
    const double a = 2.0 * std::cos(phase), b = std::sin(phase);
    watch.add(sample(5.0 + a * std::cos(kTurn) - b * std::sin(kTurn), a * std::sin(kTurn) + b * std::cos(kTurn)), i,
              1.0);
  }
  EXPECT_EQ(testing::allocation_count(), before);
  const VesselDynamics r = watch.results();
  const double c = std::cos(kTurn), s = std::sin(kTurn);
  EXPECT_NEAR(r.surge.whole.mean, 5.0, 1e-9);
  EXPECT_NEAR(r.along.whole.mean, 0.0, 1e-9);
  EXPECT_NEAR(r.along.whole.std, std::sqrt(2.0 * c * c + 0.5 * s * s), 1e-9);
  EXPECT_NEAR(r.across.whole.std, std::sqrt(2.0 * s * s + 0.5 * c * c), 1e-9);
  EXPECT_NEAR(r.covariance, 1.5 * c * s, 1e-9);
  EXPECT_NEAR(r.offset.whole.max, 2.0, 1e-9);
  EXPECT_NEAR(r.offset.whole.min, 1.0, 1e-9);
  EXPECT_EQ(r.start_surge, 5.0);
}

TEST(vessel_watch, comes_out_of_a_checkpoint_bit_for_bit) {
  VesselRecorder vessel_watch(drawn()), second(drawn());
  vessel_watch.start(drawn());
  second.start(drawn());
  const VesselPose vessel_pose{drawn().p_WV + Vec3(0.3, 0.1, 0.0), drawn().R_WV};
  vessel_watch.add(vessel_pose, 1.0, 0.25);
  second.restore(vessel_watch.save());
  vessel_watch.add(drawn(), 2.0, 0.5);
  second.add(drawn(), 2.0, 0.5);
  EXPECT_EQ(vessel_watch.save(), second.save());
}

}  // namespace
}  // namespace overbend
