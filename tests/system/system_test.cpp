#include "system/system.h"

#include <gtest/gtest.h>

namespace overbend {
namespace {

/// A body that turns about its z at a steady rate while it goes ahead.
RigidMotion turning(double t) {
  constexpr double kRate = 0.3;
  RigidMotion motion;
  motion.pose.R_WV = Eigen::AngleAxisd(kRate * t, Vec3::UnitZ()).toRotationMatrix();
  motion.pose.p_WV = Vec3(2.0 * t, 0.5 * t * t, 0.0);
  motion.velocity = Vec3(2.0, t, 0.0);
  motion.acceleration = Vec3(0.0, 1.0, 0.0);
  motion.omega = Vec3(0.0, 0.0, kRate);
  return motion;
}

TEST(attachment, on_a_body_has_the_rates_of_its_path) {
  const Vec3 place(-30.0, 4.0, 2.0), direction = Vec3(1.0, 0.2, 0.1).normalized();
  constexpr double kTime = 1.7, kStep = 1e-4;
  const auto sample = [&](double t) { return attached_to(turning(t), place, direction); };
  const EndMotion end_motion = sample(kTime), before = sample(kTime - kStep), after = sample(kTime + kStep);
  EXPECT_LT((end_motion.velocity - (after.place - before.place) / (2.0 * kStep)).norm(), 1e-7);
  EXPECT_LT((end_motion.acceleration - (after.velocity - before.velocity) / (2.0 * kStep)).norm(), 1e-7);
  EXPECT_LT((end_motion.direction_rate - (after.direction - before.direction) / (2.0 * kStep)).norm(), 1e-7);
  EXPECT_LT((end_motion.direction_acceleration - (after.direction_rate - before.direction_rate) / (2.0 * kStep)).norm(),
            1e-7);
}

TEST(attachment, to_the_ground_stands_still_while_others_follow_their_bodies) {
  System system;
  system.bodies.resize(2);
  system.attachments.resize(3);
  system.attachments[0].place = Vec3(5.0, 6.0, 7.0);
  system.attachments[1].body = 0;
  system.attachments[2].body = 1;
  system.attachments[2].place = Vec3(1.0, 0.0, 0.0);
  Surroundings surroundings;
  surroundings.bodies = {turning(0.0), turning(2.0)};
  surroundings.ends.resize(3);
  surroundings.ends[0].velocity = Vec3(9.0, 9.0, 9.0);  // of an instant before
  set_attachment_motions(system, surroundings);
  EXPECT_EQ(surroundings.ends[0].place, Vec3(5.0, 6.0, 7.0));
  EXPECT_EQ(surroundings.ends[0].velocity, Vec3(Vec3::Zero()));
  EXPECT_EQ(surroundings.ends[1].place, turning(0.0).pose.p_WV);
  const EndMotion led = attached_to(turning(2.0), Vec3(1.0, 0.0, 0.0), Vec3::UnitX());
  EXPECT_EQ(surroundings.ends[2].place, led.place);
  EXPECT_EQ(surroundings.ends[2].velocity, led.velocity);
}

}  // namespace
}  // namespace overbend
