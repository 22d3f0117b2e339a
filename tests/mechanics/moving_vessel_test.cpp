#include "mechanics/moving_vessel.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/bgl1_in_time.h"

namespace overbend {
namespace {

constexpr BuildUp kFull{1.0, 0.0, 0.0};

struct InSea {
  explicit InSea(const Vec3& shift = Vec3::Zero()) : model(build_model(testing::workable())) {
    const WavesDescription& waves = model.description.environment.waves.front();
    sea = make_sea(waves, model.description.environment.water_depth, 1);
    model.mean_pose.p_WV += shift;
    motion = make_vessel_motion(model, sea);
    numbers = wave_numbers_ahead(motion, sea);
  }
  RigidMotion at(double t, const MoveState& direction) const {
    return vessel_motion(motion, MoveAhead{direction, numbers}, t, kFull);
  }

  Model model;
  Sea sea;
  VesselMotionModel motion;
  std::vector<double> numbers;
};

TEST(moving_vessel, meets_the_waves_where_it_is) {
  const InSea vessel;
  const Vec3 ahead = level_ahead(vessel.model.mean_pose);
  const InSea shifted(37.0 * ahead);
  ASSERT_EQ(vessel.numbers.size(), vessel.motion.terms.size());
  const RigidMotion moved = vessel.at(12.3, {37.0, 0.0, 0.0}), drawn = shifted.at(12.3, {});
  EXPECT_NEAR((moved.pose.p_WV - drawn.pose.p_WV).norm(), 0.0, 1e-9);
  EXPECT_NEAR((moved.pose.R_WV - drawn.pose.R_WV).norm(), 0.0, 1e-11);
  EXPECT_NEAR((moved.velocity - drawn.velocity).norm(), 0.0, 1e-10);
  EXPECT_GT((moved.pose.p_WV - vessel.at(12.3, {}).pose.p_WV - 37.0 * ahead).norm(), 1e-2);
}

// A hull at rest on its lines may lie turned: the route is that of the heading as drawn.
TEST(moving_vessel, that_lies_turned_moves_along_the_lay_route) {
  InSea vessel;
  const Mat3 turn = Eigen::AngleAxisd(0.1, Vec3::UnitZ()).toRotationMatrix();
  vessel.model.mean_pose.R_WV = turn * vessel.model.nominal_pose.R_WV;
  const VesselMotionModel motion = make_vessel_motion(vessel.model, vessel.sea);
  const auto sample = [&](double distance) {
    return vessel_motion(motion, MoveAhead{{distance, 0.0, 0.0}, {}}, 3.0, kFull);
  };
  const Vec3 moved = sample(12.0).pose.p_WV - sample(0.0).pose.p_WV;
  EXPECT_LT((moved - 12.0 * level_ahead(vessel.model.nominal_pose)).norm(), 1e-9);
}

TEST(moving_vessel, rates_are_those_of_its_places) {
  const InSea vessel;
  constexpr double kSpeed = 3.0, kRise = 0.4, kStep = 1e-4, kTime = 20.0;
  const auto sample = [&](double t) {
    return vessel.at(t, {kSpeed * t + 0.5 * kRise * t * t, kSpeed + kRise * t, kRise});
  };
  const RigidMotion before = sample(kTime - kStep), present = sample(kTime), after = sample(kTime + kStep);
  const Vec3 velocity = (after.pose.p_WV - before.pose.p_WV) / (2.0 * kStep);
  const Vec3 acceleration = (after.velocity - before.velocity) / (2.0 * kStep);
  EXPECT_NEAR((present.velocity - velocity).norm(), 0.0, 1e-6);
  EXPECT_NEAR((present.acceleration - acceleration).norm(), 0.0, 1e-6);
  EXPECT_NEAR((present.alpha - (after.omega - before.omega) / (2.0 * kStep)).norm(), 0.0, 1e-7);
}

TEST(moving_vessel, at_rest_is_the_vessel_that_does_not_move) {
  const InSea vessel;
  const RigidMotion a = vessel.at(5.0, {}), b = vessel_motion(vessel.motion, 5.0, kFull);
  EXPECT_EQ(a.pose.p_WV, b.pose.p_WV);
  EXPECT_EQ(a.velocity, b.velocity);
  EXPECT_EQ(a.acceleration, b.acceleration);
  EXPECT_EQ(a.alpha, b.alpha);
}

}  // namespace
}  // namespace overbend
