#include "hull/rigid_body.h"

#include <gtest/gtest.h>

#include "hull/body_kinematics.h"

namespace overbend {
namespace {

/// A body without symmetry.
RigidBody lopsided() {
  RigidBody body;
  body.mass = 19.0;
  body.inertia << 21.0, 3.0, -2.0, 3.0, 170.0, 5.0, -2.0, 5.0, 160.0;
  return body;
}

const Vec6 kPlace = (Vec6() << 3.0, -8.0, 1.5, 0.31, -0.42, 2.9).finished();
const Vec6 kRates = (Vec6() << 0.4, 1.1, -0.7, 0.25, -0.33, 0.18).finished();
const Vec6 kAccelerations = (Vec6() << -0.2, 0.5, 0.9, 0.12, 0.27, -0.4).finished();

TEST(rigid_body, force_is_the_rate_of_momentum) {
  const RigidBody body = lopsided();
  const auto spin = [&](double t) -> Vec3 {
    const BodyMotion m = make_body_motion(kPlace + kRates * t + 0.5 * kAccelerations * t * t,
                                          kRates + kAccelerations * t, kAccelerations);
    return m.pose.R * body.inertia * m.pose.R.transpose() * m.omega;
  };
  const double d = 1e-4;
  const Vec3 moment = (spin(d) - spin(-d)) / (2.0 * d);
  const Vec6 force = rigid_body_force(body, kPlace, kRates, kAccelerations).force;
  EXPECT_LT((force.head<3>() - body.mass * kAccelerations.head<3>()).norm(), 1e-12);
  EXPECT_LT((force - body.mass * (Vec6() << kAccelerations.head<3>(), Vec3::Zero()).finished() -
             generalised_moment(make_pose(kPlace), moment))
                .norm(),
            1e-5);  // central differences
}

TEST(rigid_body, derivatives_agree_with_differences) {
  const RigidBody body = lopsided();
  const RigidBodyForce exact = rigid_body_force(body, kPlace, kRates, kAccelerations);
  const double d = 1e-5;
  for (int k = 0; k < 6; ++k) {
    const Vec6 e = d * Vec6::Unit(k);
    const auto slope = [&](const Vec6& dh, const Vec6& dv, const Vec6& da) -> Vec6 {
      return (rigid_body_force(body, kPlace + dh, kRates + dv, kAccelerations + da).force -
              rigid_body_force(body, kPlace - dh, kRates - dv, kAccelerations - da).force) /
             (2.0 * d);
    };
    const Vec6 zero = Vec6::Zero();
    EXPECT_LT((exact.by_h.col(k) - slope(e, zero, zero)).norm(), 1e-7) << k;
    EXPECT_LT((exact.by_v.col(k) - slope(zero, e, zero)).norm(), 1e-7) << k;
    EXPECT_LT((exact.by_a.col(k) - slope(zero, zero, e)).norm(), 1e-7) << k;
  }
}

/// Classical Runge-Kutta steps of the free body.
void tumble(const RigidBody& body, Vec6& h, Vec6& v, double step) {
  const auto acceleration = [&](const Vec6& x, const Vec6& u) -> Vec6 {
    const RigidBodyForce f = rigid_body_force(body, x, u, Vec6::Zero());
    return -f.by_a.partialPivLu().solve(f.force);
  };
  const Vec6 a1 = acceleration(h, v);
  const Vec6 v2 = v + 0.5 * step * a1, a2 = acceleration(h + 0.5 * step * v, v2);
  const Vec6 v3 = v + 0.5 * step * a2, a3 = acceleration(h + 0.5 * step * v2, v3);
  const Vec6 v4 = v + step * a3, a4 = acceleration(h + step * v3, v4);
  h += step / 6.0 * (v + 2.0 * v2 + 2.0 * v3 + v4);
  v += step / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
}

TEST(rigid_body, free_tumbling_keeps_energy_and_momentum) {
  const RigidBody body = lopsided();
  Vec6 h = kPlace, v = kRates;
  const auto spin = [&]() -> Vec3 {
    const BodyMotion m = make_body_motion(h, v, Vec6::Zero());
    return m.pose.R * body.inertia * m.pose.R.transpose() * m.omega;
  };
  const double energy = kinetic_energy(body, h, v);
  const Vec3 momentum = spin();
  for (int i = 0; i < 300; ++i) tumble(body, h, v, 0.01);
  // Fourth-order steps of 0.01 s at rates of 0.4 rad/s: 1e-10.
  EXPECT_NEAR(kinetic_energy(body, h, v), energy, 1e-9 * energy);
  EXPECT_LT((spin() - momentum).norm(), 1e-9 * momentum.norm());
}

}  // namespace
}  // namespace overbend
