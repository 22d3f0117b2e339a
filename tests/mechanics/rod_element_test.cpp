#include "mechanics/rod_element.h"

#include <gtest/gtest.h>

#include "support/fixtures.h"

namespace overbend {
namespace {

constexpr RodProperties kRod{1.3, 2.86e9, 5.59e7};

TEST(rod_element, force_is_the_derivative_of_the_energy) {
  const ElementVector q = testing::element_dofs(testing::wavy_line(2, 1.3, Vec3::Zero(), 2), 0);
  const RodForce at = rod_force(kRod, q);
  for (int i = 0; i < 12; ++i) {
    ElementVector up = q, down = q;
    up(i) += 1e-6;
    down(i) -= 1e-6;
    const double slope = (rod_force(kRod, up).energy - rod_force(kRod, down).energy) / 2e-6;
    EXPECT_NEAR(slope, at.force(i), 1e-7 * at.force.cwiseAbs().maxCoeff());  // central difference, step 1e-6
  }
}

TEST(rod_element, stiffness_is_the_derivative_of_the_force_and_symmetric) {
  const ElementVector q = testing::element_dofs(testing::wavy_line(2, 1.3, Vec3::Zero(), 4), 0);
  const RodForce at = rod_force(kRod, q);
  const double largest = at.stiffness.cwiseAbs().maxCoeff();
  for (int i = 0; i < 12; ++i) {
    ElementVector up = q, down = q;
    up(i) += 1e-6;
    down(i) -= 1e-6;
    const ElementVector slope = (rod_force(kRod, up).force - rod_force(kRod, down).force) / 2e-6;
    EXPECT_LT((slope - at.stiffness.col(i)).cwiseAbs().maxCoeff(), 1e-8 * largest);
  }
  EXPECT_LT((at.stiffness - at.stiffness.transpose()).cwiseAbs().maxCoeff(), 1e-14 * largest);
}

TEST(rod_element, a_straight_stretch_stores_half_EA_strain_squared) {
  ElementVector q;
  q << 0, 0, 0, 1.001, 0, 0, 1.3 * 1.001, 0, 0, 1.001, 0, 0;
  EXPECT_NEAR(rod_force(kRod, q).energy, 0.5 * kRod.EA * 1e-6 * kRod.length, 1e-9 * kRod.EA * 1e-6);
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
