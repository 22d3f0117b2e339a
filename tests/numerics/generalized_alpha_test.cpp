#include "numerics/generalized_alpha.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace overbend {
namespace {

/// One step of q'' = -omega^2 q as a linear map of (q, v, acc, alg) with h = 1: the equation holds for the true
/// acceleration at the end.
Eigen::Matrix4d step_map(const GeneralizedAlpha& g, double omega) {
  Eigen::Matrix4d map;
  const double w2 = omega * omega;
  for (int column = 0; column < 4; ++column) {
    const Eigen::Vector4d from = Eigen::Vector4d::Unit(column);
    const MotionValues motion_values{from(0), from(1), from(2), from(3)};
    // The place is linear in the true acceleration.
    const double without = advance(g, motion_values, 1.0, 0.0).q;
    const double slope = advance(g, motion_values, 1.0, 1.0).q - without;
    const MotionValues next = advance(g, motion_values, 1.0, -w2 * without / (1.0 + w2 * slope));
    map.col(column) << next.q, next.v, next.acc, next.algorithmic_acceleration;
  }
  return map;
}

double spectral_radius(const GeneralizedAlpha& g, double omega) {
  return step_map(g, omega).eigenvalues().cwiseAbs().maxCoeff();
}

class any_radius : public ::testing::TestWithParam<double> {};

TEST_P(any_radius, fast_vibrations_shrink_by_the_radius_asked_every_step) {
  // Three eigenvalues meet in the limit, so it is approached as the cube root of (omega h)^-2 = 1e-8.
  EXPECT_NEAR(spectral_radius(GeneralizedAlpha(GetParam()), 1e4), GetParam(), 3e-3);
}

TEST_P(any_radius, no_frequency_grows) {
  for (double omega = 1e-3; omega < 1e4; omega *= 1.3) {
    EXPECT_LE(spectral_radius(GeneralizedAlpha(GetParam()), omega), 1.0 + 1e-10) << omega;  // rounding of eigenvalues
  }
}

TEST_P(any_radius, shares_are_the_derivatives_of_the_step) {
  const GeneralizedAlpha g(GetParam());
  const MotionValues motion_values{0.3, -1.2, 2.0, 1.7};
  const double h = 0.05;
  const MotionValues a = advance(g, motion_values, h, 1.0), b = advance(g, motion_values, h, 4.0);
  EXPECT_NEAR((b.v - a.v) / (b.q - a.q), g.velocity_share(h), 1e-9 * g.velocity_share(h));
  EXPECT_NEAR(3.0 / (b.q - a.q), g.acceleration_share(h), 1e-9 * g.acceleration_share(h));
}

TEST_P(any_radius, second_order_needs_gamma_and_beta_of_chung_and_hulbert) {
  const GeneralizedAlpha g(GetParam());
  EXPECT_NEAR(g.gamma, 0.5 - g.alpha_m + g.alpha_f, 1e-15);
  EXPECT_NEAR(g.beta, 0.25 * std::pow(1.0 - g.alpha_m + g.alpha_f, 2), 1e-15);
  EXPECT_LE(g.alpha_m, g.alpha_f);
  EXPECT_LE(g.alpha_f, 0.5);
}

TEST_P(any_radius, free_vibration_is_followed_to_second_order) {
  const GeneralizedAlpha g(GetParam());
  const auto error = [&](int steps) {
    const double h = 3.0 / steps;
    const Eigen::Matrix4d map = step_map(g, h);  // time in units of h
    Eigen::Vector4d state(1.0, 0.0, -h * h, -h * h);
    for (int i = 0; i < steps; ++i) state = map * state;
    return std::hypot(state(0) - std::cos(3.0), state(1) / h + std::sin(3.0));
  };
  EXPECT_NEAR(std::log2(error(100) / error(200)), 2.0, 0.05);  // the next order is h = 0.03 smaller
}

TEST_P(any_radius, steady_acceleration_is_followed_exactly) {
  const GeneralizedAlpha g(GetParam());
  MotionValues state{0.0, 0.0, 2.0, 2.0};
  for (int i = 0; i < 10; ++i) state = advance(g, state, 0.1, 2.0);
  EXPECT_NEAR(state.q, 1.0, 1e-14);
  EXPECT_NEAR(state.v, 2.0, 1e-14);
}

TEST_P(any_radius, a_steady_change_of_acceleration_is_extrapolated_by_half_at_most) {
  const GeneralizedAlpha g(GetParam());
  constexpr double kStep = 0.1, kChange = 3.0;
  MotionValues state{0.0, 0.0, 2.0, 2.0};
  for (int i = 0; i < 500; ++i) state = advance(g, state, kStep, state.acc + kChange * kStep);
  const double half = 0.5 * kChange * kStep,
               extrapolated =
                   g.extrapolated(state.acc, state.algorithmic_acceleration, g.half_extrapolation) - state.acc;
  EXPECT_LE(extrapolated, half + 1e-9);
  EXPECT_GE(extrapolated, std::min(half, 2.0 * (g.alpha_f - g.alpha_m) * kChange * kStep) - 1e-9);
  EXPECT_NEAR(g.extrapolated(state.acc, state.algorithmic_acceleration, g.full_extrapolation) - state.acc,
              std::min(1.0, 20.0 * (g.alpha_f - g.alpha_m)) * kChange * kStep, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(generalized_alpha, any_radius, ::testing::Values(0.0, 0.5, 0.8, 0.95, 1.0));

TEST(generalized_alpha, radius_of_one_does_not_damp) {
  for (const double omega : {0.1, 1.0, 10.0}) {
    const Eigen::Vector4cd values = step_map(GeneralizedAlpha(1.0), omega).eigenvalues();
    int kept = 0;
    for (const auto& value : values) kept += std::abs(std::abs(value) - 1.0) < 1e-9 ? 1 : 0;
    EXPECT_GE(kept, 2) << omega;  // the pair that carries the vibration
  }
}

TEST(generalized_alpha, radius_of_four_fifths_damps_only_what_the_step_does_not_resolve) {
  const auto kept_in_a_period = [](double steps) {
    return std::pow(spectral_radius(GeneralizedAlpha(0.8), 2.0 * std::numbers::pi / steps), steps);
  };
  EXPECT_NEAR(1.0 - kept_in_a_period(50.0), 1e-5, 0.2e-5);
  EXPECT_NEAR(1.0 - kept_in_a_period(4.0), 1e-2, 0.1e-2);
  EXPECT_NEAR(spectral_radius(GeneralizedAlpha(0.8), 4.0 * std::numbers::pi), 0.92, 0.005);  // two periods to the step
}

}  // namespace
}  // namespace overbend
