#include "mechanics/rod_element.h"

#include <gtest/gtest.h>

#include "mechanics/slack_law.h"
#include "support/fixtures.h"

namespace overbend {
namespace {

constexpr RodProperties kRod{1.3, 2.86e9, 5.59e7};

TEST(rod_element, force_is_the_derivative_of_the_energy) {
  const ElementVector q = testing::element_dofs(testing::wavy_line(2, 1.3, Vec3::Zero(), 2), 0);
  const RodForce rod_result = rod_force(kRod, q);
  for (int i = 0; i < 12; ++i) {
    ElementVector up = q, down = q;
    up(i) += 1e-6;
    down(i) -= 1e-6;
    const double slope = (rod_force(kRod, up).energy - rod_force(kRod, down).energy) / 2e-6;
    EXPECT_NEAR(slope, rod_result.force(i),
                1e-7 * rod_result.force.cwiseAbs().maxCoeff());  // central difference, step 1e-6
  }
}

TEST(rod_element, stiffness_is_the_derivative_of_the_force_and_symmetric) {
  const ElementVector q = testing::element_dofs(testing::wavy_line(2, 1.3, Vec3::Zero(), 4), 0);
  const RodForce rod_result = rod_force(kRod, q);
  const double max_value = rod_result.stiffness.cwiseAbs().maxCoeff();
  for (int i = 0; i < 12; ++i) {
    ElementVector up = q, down = q;
    up(i) += 1e-6;
    down(i) -= 1e-6;
    const ElementVector slope = (rod_force(kRod, up).force - rod_force(kRod, down).force) / 2e-6;
    EXPECT_LT((slope - rod_result.stiffness.col(i)).cwiseAbs().maxCoeff(), 1e-8 * max_value);
  }
  EXPECT_LT((rod_result.stiffness - rod_result.stiffness.transpose()).cwiseAbs().maxCoeff(), 1e-14 * max_value);
}

// Stretched, slack and in the transition at its three points, with steps that stay within each.
TEST(rod_element, derivatives_of_what_only_pulls_are_exact) {
  ElementVector q = testing::element_dofs(testing::wavy_line(2, 1.3, Vec3::Zero(), 2), 0);
  const Vec3 first = q.segment<3>(3).normalized(), last = q.segment<3>(9).normalized();
  for (const double strain : {2e-3, -3e-3, 0.3 * kSlackStrain}) {
    q.segment<3>(3) = (1.0 + strain) * first;
    q.segment<3>(9) = (1.0 - strain) * last;
    const RodProperties rod{1.3, 5e8, 50.0, kSlackShare};
    const RodForce rod_result = rod_force(rod, q);
    constexpr double kStep = 1e-8;
    for (int i = 0; i < 12; ++i) {
      ElementVector up = q, down = q;
      up(i) += kStep;
      down(i) -= kStep;
      const RodForce above = rod_force(rod, up), below = rod_force(rod, down);
      EXPECT_NEAR((above.energy - below.energy) / (2.0 * kStep), rod_result.force(i),
                  1e-5 * rod_result.force.cwiseAbs().maxCoeff());
      const ElementVector slope = (above.force - below.force) / (2.0 * kStep);
      EXPECT_LT((slope - rod_result.stiffness.col(i)).cwiseAbs().maxCoeff(),
                1e-5 * rod_result.stiffness.cwiseAbs().maxCoeff());
    }
  }
}

TEST(rod_element, a_straight_stretch_stores_half_EA_strain_squared) {
  ElementVector q;
  q << 0, 0, 0, 1.001, 0, 0, 1.3 * 1.001, 0, 0, 1.001, 0, 0;
  EXPECT_NEAR(rod_force(kRod, q).energy, 0.5 * kRod.EA * 1e-6 * kRod.length, 1e-9 * kRod.EA * 1e-6);
}

/// Straight, of a length that is stretched evenly.
ElementVector straight(double strain, double length) {
  ElementVector q;
  q << 0, 0, 0, 1 + strain, 0, 0, length * (1 + strain), 0, 0, 1 + strain, 0, 0;
  return q;
}

TEST(rod_element, of_what_only_pulls_bears_no_compression_whatever_its_length) {
  for (const double length : {0.5, 5.0, 50.0}) {
    const RodProperties rod{length, 5e8, 50.0, kSlackShare};
    const auto pull = [&](double strain) { return rod_force(rod, straight(strain, length)).force(6); };
    EXPECT_NEAR(pull(1e-3), 5e5, 1e-6 * 5e5);
    EXPECT_NEAR(pull(0.0), 0.25 * 5e8 * kSlackStrain, 1e-6 * 1250.0);  // in the middle of the transition
    EXPECT_NEAR(pull(-kSlackStrain), 0.0, 1e-2);
    EXPECT_NEAR(pull(-0.1), -5.9, 0.1);  // of the share that stays: 50 N (0.9 - 0.9^-3)/4
    EXPECT_LT(pull(-0.99), -1e7);        // no element shrinks to nothing
  }
}

TEST(rod_element, curvature_of_an_arc_is_one_over_its_radius) {
  const double radius = 150.0, angle = 0.5 / radius;
  ElementVector q;
  q << 0, 0, 0, 1, 0, 0, radius * std::sin(angle), 0, radius * (1 - std::cos(angle)), std::cos(angle), 0,
      std::sin(angle);
  EXPECT_NEAR(curvature(centreline(q, 0.5, 0.5)), 1.0 / radius, 1e-6 / radius);  // cubic against arc: (h/R)^2 relative
}

}  // namespace
}  // namespace overbend
