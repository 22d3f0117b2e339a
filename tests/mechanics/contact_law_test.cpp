#include "mechanics/contact_law.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace overbend {
namespace {

constexpr double kStep = 0.01;

ContactLaw law() {
  return {1e6, 5e3, 4e5, 2e3, 0.1, 0.4};
}

class Random {
 public:
  double in(double low, double high) {
    return low + (high - low) * static_cast<double>(generator_() >> 11) * 0x1.0p-53;
  }

 private:
  std::mt19937_64 generator_{7};
};

TEST(contact_law, never_pulls) {
  Random random;
  for (int i = 0; i < 10000; ++i) {
    const NormalForce n = normal_force(law(), random.in(-0.02, 0.02), random.in(-5.0, 5.0));
    ASSERT_GE(n.force, 0.0);
  }
}

TEST(contact_law, pushes_with_spring_and_dashpot_while_both_together_push) {
  EXPECT_DOUBLE_EQ(normal_force(law(), 0.01, 0.5).force, 1e4 + 2.5e3);
  EXPECT_DOUBLE_EQ(normal_force(law(), 0.01, -0.5).force, 1e4 - 2.5e3);
  EXPECT_EQ(normal_force(law(), 0.01, -2.1).force, 0.0);  // released while the spring is still compressed
  EXPECT_EQ(normal_force(law(), -1e-9, 3.0).force, 0.0);  // a dashpot does not act at a distance
}

TEST(contact_law, force_vanishes_steadily_where_the_rebound_lets_go) {
  const double rate = -1.0, release = law().damping / law().stiffness;
  EXPECT_EQ(normal_force(law(), release * (1.0 - 1e-9), rate).force, 0.0);
  EXPECT_NEAR(normal_force(law(), release * (1.0 + 1e-9), rate).force, 0.0, 1e-4);  // 1e-9 of 5 kN, 20-fold
}

TEST(contact_law, derivatives_of_the_normal_force_are_those_of_finite_differences) {
  Random random;
  constexpr double kSmall = 1e-7;
  for (int i = 0; i < 1000; ++i) {
    const double g = random.in(-0.02, 0.02), rate = random.in(-5.0, 5.0);
    const auto force = [](double penetration, double speed) { return normal_force(law(), penetration, speed).force; };
    const NormalForce n = normal_force(law(), g, rate);
    const double near_release = std::abs(law().stiffness * g + law().damping * rate);
    if (std::abs(g) < 2.0 * kSmall || near_release < 1.0) {
      continue;  // a kink between the two points of the difference
    }
    // The law is linear between its kinks: rounding of 1e4 N over 1e-7 is all.
    EXPECT_NEAR(n.by_penetration, (force(g + kSmall, rate) - force(g - kSmall, rate)) / (2.0 * kSmall), 1e-3);
    EXPECT_NEAR(n.by_rate, (force(g, rate + kSmall) - force(g, rate - kSmall)) / (2.0 * kSmall), 1e-3);
  }
}

TEST(contact_law, derivatives_of_friction_are_those_of_finite_differences_sticking_and_sliding) {
  Random random;
  constexpr double kSmall = 1e-7;
  const double mu = law().friction_lateral;
  int sticking = 0, sliding = 0;
  for (int i = 0; i < 1000; ++i) {
    const double slip = random.in(-0.02, 0.02), rate = random.in(-1.0, 1.0), normal = random.in(0.0, 2e4);
    const auto force = [&](double speed, double push) {
      return friction_force(law(), mu, {slip, speed, kStep, push}).force;
    };
    const FrictionForce f = friction_force(law(), mu, {slip, rate, kStep, normal});
    const double trial = law().tangential_stiffness * (slip + kStep * rate) + law().tangential_damping * rate;
    if (std::abs(std::abs(trial) - mu * normal) < 1.0) {
      continue;  // the kink at the limit
    }
    ++(std::abs(trial) > mu * normal ? sliding : sticking);
    EXPECT_NEAR(f.by_rate, (force(rate + kSmall, normal) - force(rate - kSmall, normal)) / (2.0 * kSmall), 1e-3);
    EXPECT_NEAR(f.by_normal, (force(rate, normal + 1.0) - force(rate, normal - 1.0)) / 2.0, 1e-9);
  }
  EXPECT_GT(sticking, 100);
  EXPECT_GT(sliding, 100);
}

TEST(contact_law, derivatives_of_friction_are_exact_where_the_slip_turns_within_the_step) {
  Random random;
  constexpr double kSmall = 1e-7;
  const double mu = law().friction_lateral;
  int turned = 0, clipped = 0;
  for (int i = 0; i < 2000; ++i) {
    const double slip = random.in(-0.002, 0.002), start = random.in(-1.0, 1.0), rate = random.in(-0.3, 0.3);
    const double normal = random.in(1e3, 2e4);
    const auto force = [&](double speed, double push) {
      return friction_in_state(law(), mu, {slip, speed, kStep, push, start}, Slip::stick).force;
    };
    const SlipStep step{slip, rate, kStep, normal, start};
    const FrictionForce f = friction_in_state(law(), mu, step, Slip::stick);
    const ElasticSlip elastic = elastic_slip(step, mu * normal / law().tangential_stiffness);
    turned += start * rate < 0.0;
    clipped += elastic.by_max_slip != 0.0;
    EXPECT_NEAR(f.by_rate, (force(rate + kSmall, normal) - force(rate - kSmall, normal)) / (2.0 * kSmall),
                1e-4 * std::abs(f.by_rate) + 1e-2);
    EXPECT_NEAR(f.by_normal, (force(rate, normal + 1e-3) - force(rate, normal - 1e-3)) / 2e-3, 1e-5);
  }
  EXPECT_GT(turned, 500);
  EXPECT_GT(clipped, 50);
}

/// Work of friction on a slip that oscillates for two periods, by steps that know the rates at both their ends.
double work_of_friction(int steps_per_period) {
  const double mu = 0.4, normal = 1e4, stretch = mu * normal / law().tangential_stiffness;
  ContactLaw dry = law();
  dry.tangential_damping = 0.0;
  const double period = 1.0, h = period / steps_per_period, omega = 2.0 * std::numbers::pi / period;
  const auto rate = [&](double t) { return 3.0 * stretch * omega * std::cos(omega * t); };  // three times the limit
  double slip = 0.0, work = 0.0, force = 0.0;
  for (int i = 1; i <= 2 * steps_per_period; ++i) {
    const double before = rate((i - 1) * h), present = rate(i * h);
    const FrictionForce f = friction_force(dry, mu, {slip, present, h, normal, before});
    work -= 0.5 * h * (force * before + f.force * present);
    force = f.force;
    slip = f.slip;
  }
  return work;
}

TEST(contact_law, friction_loses_what_a_slider_behind_a_spring_does_with_an_error_of_second_order) {
  // Slid between the turns at three times the stretch either way, of which two go into turning the spring: 2 + 4 + 4 +
  // 4 + 1 stretches; and half of one in the spring at the end.
  const double limit = 0.4e4, stretch = limit / law().tangential_stiffness, exact = 15.5 * limit * stretch;
  const double coarse = work_of_friction(40) / exact - 1.0, fine = work_of_friction(160) / exact - 1.0;
  EXPECT_NEAR(fine, 0.0, 2e-3);
  EXPECT_LT(std::abs(fine), 0.2 * std::abs(coarse) + 2e-4);
}

TEST(contact_law, friction_opposes_and_stays_below_the_limit) {
  Random random;
  for (int i = 0; i < 10000; ++i) {
    const double slip = random.in(-0.02, 0.02), rate = random.in(-1.0, 1.0), normal = random.in(0.0, 2e4);
    const FrictionForce f = friction_force(law(), 0.4, {slip, rate, kStep, normal});
    ASSERT_LE(std::abs(f.force), 0.4 * normal * (1.0 + 1e-15));
    const double trial = law().tangential_stiffness * (slip + kStep * rate) + law().tangential_damping * rate;
    ASSERT_LE(f.force * trial, 0.0);
  }
}

TEST(contact_law, friction_is_continuous_at_the_limit) {
  const double mu = 0.4, normal = 1e4, limit = mu * normal;
  const double rate = limit / (law().tangential_stiffness * kStep + law().tangential_damping);
  const FrictionForce below = friction_force(law(), mu, {0.0, rate * (1.0 - 1e-9), kStep, normal});
  const FrictionForce above = friction_force(law(), mu, {0.0, rate * (1.0 + 1e-9), kStep, normal});
  EXPECT_LT(below.by_rate, 0.0);
  EXPECT_EQ(above.by_rate, 0.0);
  EXPECT_NEAR(below.force, above.force, 2e-9 * limit);
}

TEST(contact_law, sliding_keeps_the_stretch_that_the_limit_allows) {
  const double mu = 0.4, normal = 1e4, stretch = mu * normal / law().tangential_stiffness;
  const FrictionForce sliding = friction_force(law(), mu, {0.9 * stretch, 1.0, kStep, normal});
  EXPECT_DOUBLE_EQ(sliding.slip, stretch);
  EXPECT_DOUBLE_EQ(sliding.force, -mu * normal);
  // Turned back, it first yields elastically from there.
  const FrictionForce back = friction_force(law(), mu, {sliding.slip, -0.1, kStep, normal});
  EXPECT_DOUBLE_EQ(back.slip, stretch - 0.1 * kStep);
  EXPECT_NEAR(back.force, -mu * normal + 0.1 * (law().tangential_stiffness * kStep + law().tangential_damping), 1e-9);
}

TEST(contact_law, a_roller_without_friction_lets_slide_freely) {
  ContactLaw smooth = law();
  const FrictionForce f = friction_force(smooth, 0.0, {0.0, 2.0, kStep, 1e4});
  EXPECT_EQ(f.force, 0.0);
  smooth.tangential_stiffness = 0.0;
  EXPECT_EQ(friction_force(smooth, 0.3, {0.0, 2.0, kStep, 1e4}).slip, 0.0);  // no spring, nothing to remember
}

}  // namespace
}  // namespace overbend
