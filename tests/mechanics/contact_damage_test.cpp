#include "mechanics/contact_damage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace overbend {
namespace {

constexpr double kDiameter = 0.4064, kWall = 0.011125, kYield = 414e6;

TEST(dent, work_of_the_force_is_the_energy_of_the_recommended_practice) {
  const double force = 400e3;
  // The force that belongs to each depth is found by halving; its work up to the depth by Simpson's rule in the square
  // root of the depth, in which it is a parabola.
  const double depth = dent_depth(force, kDiameter, kWall, kYield);
  const auto force_at = [](double wanted) {
    double low = 0.0, high = 1e8;
    for (int i = 0; i < 80; ++i) {
      const double middle = 0.5 * (low + high);
      (dent_depth(middle, kDiameter, kWall, kYield) < wanted ? low : high) = middle;
    }
    return low;
  };
  const double root = std::sqrt(depth);
  const double work = root / 6.0 * (4.0 * force_at(0.25 * depth) * root + force_at(depth) * 2.0 * root);
  const double plastic_moment = 0.25 * kYield * kWall * kWall;
  const double energy = 16.0 * std::sqrt(2.0 * std::numbers::pi / 9.0) * plastic_moment * std::sqrt(kDiameter / kWall) *
                        kDiameter * std::pow(depth / kDiameter, 1.5);
  EXPECT_NEAR(work, energy, 1e-9 * energy);
}

TEST(dent, of_a_five_percent_deep_dent_takes_the_force_worked_out_by_hand) {
  // m_p = 414e6 * 0.011125^2 / 4 = 12.810 kN; sqrt(D/t) = 6.0440; 24 * 0.83555 * 12.810 * 6.0440 * sqrt(0.05) = 347.2
  // kN
  EXPECT_NEAR(dent_depth(347.2e3, kDiameter, kWall, kYield), 0.05 * kDiameter, 1e-3 * 0.05 * kDiameter);
}

/// Energy is two thirds of force times depth, because the force grows with the root of the depth.
TEST(dent, a_five_percent_deep_dent_takes_the_energy_worked_out_by_hand) {
  const double depth = dent_depth(347.16e3, kDiameter, kWall, kYield);
  EXPECT_NEAR(depth, 0.05 * kDiameter, 1e-4 * 0.05 * kDiameter);  // five digits of the force
  EXPECT_NEAR(2.0 / 3.0 * 347.16e3 * depth, 4703.0, 1.0);
}

TEST(dent, grows_with_the_square_of_the_force_and_has_no_threshold) {
  const double single = dent_depth(100e3, kDiameter, kWall, kYield);
  EXPECT_GT(single, 0.0);
  EXPECT_NEAR(dent_depth(300e3, kDiameter, kWall, kYield), 9.0 * single, 1e-12 * single);
  EXPECT_EQ(dent_depth(0.0, kDiameter, kWall, kYield), 0.0);
  EXPECT_EQ(dent_depth(-5.0, kDiameter, kWall, kYield), 0.0);
}

TEST(dent, a_thicker_or_stronger_wall_dents_less) {
  const double depth = dent_depth(200e3, kDiameter, kWall, kYield);
  EXPECT_NEAR(dent_depth(200e3, kDiameter, 2.0 * kWall, kYield), depth / 8.0, 1e-12 * depth);  // F ~ t^(3/2)
  EXPECT_NEAR(dent_depth(200e3, kDiameter, kWall, 2.0 * kYield), depth / 4.0, 1e-12 * depth);
}

TEST(contact_length, is_the_chord_that_touches_the_steel) {
  EXPECT_NEAR(contact_length(1.0, 0.5, 0.3), 0.4, 1e-15);  // right triangle of 3, 4, 5
}

TEST(contact_length, is_not_more_than_the_roller_and_none_without_coating) {
  EXPECT_EQ(contact_length(0.25, 0.5, 0.3), 0.25);
  EXPECT_EQ(contact_length(0.25, 0.3, 0.3), 0.0);
}

TEST(line_load, is_force_over_length_and_none_where_nothing_can_be_crushed) {
  EXPECT_EQ(line_load(100e3, 0.25), 400e3);
  EXPECT_EQ(line_load(-1.0, 0.25), 0.0);
  EXPECT_EQ(line_load(100e3, 0.0), 0.0);
}

TEST(contact_damage, a_cable_has_no_wall_to_dent) {
  CableDescription cable;
  cable.diameter = 0.076;
  cable.weight_in_air = 240.0;
  cable.weight_submerged = 205.0;
  cable.axial_stiffness = 270e6;
  EXPECT_EQ(dent_depth(50e3, cable_section(cable, 10.05e3)), 0.0);
}

}  // namespace
}  // namespace overbend
