#include "system/vessel_body.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/fixtures.h"

namespace overbend {
namespace {

/// One box of one row in the air.
Description one_row() {
  Description d = testing::plain_description();
  d.vessel.stern_shoe_z = 5.0;
  d.rollers.push_back({"v", {0.15, 0.6}, std::nullopt, 4e6, 0.1, 0.3, 0.4});
  BoxDescription box;
  box.x = 10.0;
  box.roller = "v";
  d.supports.boxes.push_back(box);
  return d;
}

BodyRoller only_roller(const Description& d) {
  return vessel_rollers(build_model(d)).at(0);
}

/// Damping for a share of critical damping and the mass of the pipe in air that an impact moves.
double damping(double zeta, double stiffness) {
  const Section pipe = derive_section("pipe", testing::sixteen_inch_pipe(), 10.05e3);
  return 2.0 * zeta * std::sqrt(pipe.mass() * std::cbrt(16.0 * pipe.EI / stiffness) * stiffness);
}

TEST(vessel_rollers, damp_so_that_the_mass_an_impact_moves_leaves_with_the_restitution_given) {
  const ContactLaw law = only_roller(one_row()).law;
  EXPECT_DOUBLE_EQ(law.stiffness, 4e6);
  EXPECT_NEAR(law.damping, damping(0.355, 4e6), 0.002 * law.damping);  // printed table: zeta to three digits
  EXPECT_DOUBLE_EQ(law.friction_axial, 0.1);
  EXPECT_DOUBLE_EQ(law.friction_lateral, 0.3);
}

TEST(vessel_rollers, damp_by_the_textbook_where_the_kind_says_so) {
  Description d = one_row();
  d.rollers[0].damping = RollerDamping::textbook;
  const double log = std::log(0.4), zeta = -log / std::sqrt(std::numbers::pi * std::numbers::pi + log * log);
  EXPECT_NEAR(only_roller(d).law.damping, damping(zeta, 4e6), 1e-6 * damping(zeta, 4e6));
}

TEST(vessel_rollers, take_a_tenth_of_the_normal_stiffness_across_unless_they_have_their_own) {
  Description d = one_row();
  EXPECT_DOUBLE_EQ(only_roller(d).law.tangential_stiffness, 4e5);
  d.rollers[0].tangential_stiffness = 9e6;
  const ContactLaw law = only_roller(d).law;
  EXPECT_DOUBLE_EQ(law.tangential_stiffness, 9e6);
  EXPECT_NEAR(law.tangential_damping / law.damping, 1.5, 1e-12);  // by the same share of critical damping
}

TEST(vessel_rollers, of_penalty_are_as_stiff_as_a_piece_of_pipe_as_long_as_it_is_thick) {
  Description d = one_row();
  d.rollers[0].stiffness.reset();
  d.rollers[0].default_stiffness = RollerStiffness::penalty;
  const double EI = derive_section("pipe", testing::sixteen_inch_pipe(), 10.05e3).EI;
  EXPECT_NEAR(only_roller(d).law.stiffness, EI / std::pow(0.4064, 3), 1.0);
}

TEST(vessel_rollers, of_gap_springs_neither_damp_nor_rub) {
  Description d = one_row();
  d.supports.contact = SupportContact::gap_springs;
  const ContactLaw law = only_roller(d).law;
  EXPECT_DOUBLE_EQ(law.stiffness, 4e6);
  EXPECT_EQ(law.damping, 0.0);
  EXPECT_EQ(law.tangential_damping, 0.0);
  EXPECT_EQ(law.friction_axial, 0.0);
  EXPECT_EQ(law.friction_lateral, 0.0);
}

}  // namespace
}  // namespace overbend
