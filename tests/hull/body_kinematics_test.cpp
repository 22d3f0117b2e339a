#include "hull/body_kinematics.h"

#include <gtest/gtest.h>

#include "mechanics/vessel_motion.h"

namespace overbend {
namespace {

const Vec6 kPlace = (Vec6() << 3.0, -8.0, 1.5, 0.31, -0.42, 7.9).finished();
const Vec6 kRates = (Vec6() << 0.4, 1.1, -0.7, 0.25, -0.33, 0.18).finished();
const Vec6 kAccelerations = (Vec6() << -0.2, 0.5, 0.9, 0.12, 0.27, -0.4).finished();
const Vec3 kArm(57.0, -15.0, 3.0);

/// Coordinates along a path with those rates and accelerations at t = 0.
BodyMotion along_path(double t) {
  return make_body_motion(kPlace + kRates * t + 0.5 * kAccelerations * t * t, kRates + kAccelerations * t,
                          kAccelerations);
}

TEST(body_kinematics, velocity_and_acceleration_are_the_derivatives_of_the_place) {
  const double d = 1e-4;
  const BodyPoint p = make_body_point(along_path(0.0), kArm);
  const BodyPoint after = make_body_point(along_path(d), kArm), before = make_body_point(along_path(-d), kArm);
  // Central differences: d^2/6 of the third derivatives, some 60 m (0.5 rad/s)^3.
  EXPECT_LT((p.velocity - (after.place - before.place) / (2.0 * d)).norm(), 1e-7);
  EXPECT_LT((p.acceleration - (after.velocity - before.velocity) / (2.0 * d)).norm(), 1e-7);
}

TEST(body_kinematics, derivatives_of_a_point_agree_with_differences) {
  const BodyMotion body = make_body_motion(kPlace, kRates, kAccelerations);
  const PointDerivatives exact = point_derivatives(body, body.pose.R * kArm);
  EXPECT_LT((exact.place_h - point_jacobian(body.pose, body.pose.R * kArm)).norm(), 1e-13);
  EXPECT_LT((exact.place_h * kRates - make_body_point(body, kArm).velocity).norm(), 1e-12);
  const double d = 1e-5;
  for (int k = 0; k < 6; ++k) {
    const Vec6 e = d * Vec6::Unit(k);
    const BodyPoint a = make_body_point(make_body_motion(kPlace + e, kRates, kAccelerations), kArm);
    const BodyPoint b = make_body_point(make_body_motion(kPlace - e, kRates, kAccelerations), kArm);
    EXPECT_LT((exact.place_h.col(k) - (a.place - b.place) / (2.0 * d)).norm(), 1e-7) << k;
    EXPECT_LT((exact.velocity_h.col(k) - (a.velocity - b.velocity) / (2.0 * d)).norm(), 1e-7) << k;
    EXPECT_LT((exact.acceleration_h.col(k) - (a.acceleration - b.acceleration) / (2.0 * d)).norm(), 1e-7) << k;
    const BodyPoint f = make_body_point(make_body_motion(kPlace, kRates + e, kAccelerations), kArm);
    const BodyPoint g = make_body_point(make_body_motion(kPlace, kRates - e, kAccelerations), kArm);
    EXPECT_LT((exact.acceleration_v.col(k) - (f.acceleration - g.acceleration) / (2.0 * d)).norm(), 1e-7) << k;
  }
}

TEST(body_kinematics, forces_do_the_work_of_their_points_and_their_slopes_are_exact) {
  const Vec3 force(3.0, -2.0, 5.0), moment(20.0, 70.0, -40.0);
  const BodyMotion body = make_body_motion(kPlace, kRates, kAccelerations);
  const BodyPoint p = make_body_point(body, kArm);
  EXPECT_NEAR(generalised_force(body.pose, p.arm, force).dot(kRates), force.dot(p.velocity), 1e-12);
  EXPECT_NEAR(generalised_moment(body.pose, moment).dot(kRates), moment.dot(body.omega), 1e-12);

  const Mat6 of_force = generalised_force_slope(body.pose, p.arm, force);
  const Mat6 of_moment = generalised_moment_slope(body.pose, moment);
  EXPECT_EQ(of_force, of_force.transpose());
  const double d = 1e-5;
  for (int k = 0; k < 6; ++k) {
    const BodyPose a = make_pose(kPlace + d * Vec6::Unit(k)), b = make_pose(kPlace - d * Vec6::Unit(k));
    const Vec6 by_force =
        (generalised_force(a, a.R * kArm, force) - generalised_force(b, b.R * kArm, force)) / (2.0 * d);
    const Vec6 by_moment = (generalised_moment(a, moment) - generalised_moment(b, moment)) / (2.0 * d);
    EXPECT_LT((of_force.col(k) - by_force).norm(), 1e-6) << k;
    EXPECT_LT((of_moment.col(k) - by_moment).norm(), 1e-7) << k;
  }
}

TEST(body_kinematics, coordinates_come_back_from_the_axes) {
  const BodyPose pose = make_pose(kPlace);
  Vec6 h = make_coordinates(pose.place, pose.R);
  h(5) += 2.0 * 3.14159265358979323846;  // 7.9 rad is more than a turn
  EXPECT_LT((h - kPlace).norm(), 1e-14);
  EXPECT_LT((pose.R.transpose() * pose.R - Mat3::Identity()).norm(), 1e-14);
}

TEST(body_kinematics, motion_as_a_vessels_is_that_of_its_points) {
  const Vec3 reference_V(2.0, 0.5, 0.818);
  Vec6 drawn = kPlace;
  drawn.head<3>() += Vec3(1.0, -2.0, 0.5);
  const BodyMotion body = make_body_motion(kPlace, kRates, kAccelerations);
  const RigidMotion vessel = rigid_motion(body, reference_V, drawn);
  const BodyPoint p = make_body_point(body, kArm);
  const PointMotion q = point_motion(vessel, reference_V + kArm);
  EXPECT_LT((p.place - q.place).norm(), 1e-12);
  EXPECT_LT((p.velocity - q.velocity).norm(), 1e-12);
  EXPECT_LT((p.acceleration - q.acceleration).norm(), 1e-12);
  EXPECT_NEAR(vessel.freedoms[2], -0.5, 1e-14);
  EXPECT_EQ(vessel.freedoms[5], 0.0);
}

}  // namespace
}  // namespace overbend
