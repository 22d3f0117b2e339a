#include "model/pipe/steel_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>

namespace overbend {
namespace {

constexpr double kModulus = 207e9, kYield = 414e6;

SteelDescription make_steel(MaterialLaw law) {
  SteelDescription steel;
  steel.outside_diameter = 0.4064;
  steel.wall_thickness = 0.0127;
  steel.youngs_modulus = kModulus;
  steel.yield_stress = kYield;
  steel.material.law = law;
  steel.material.hardening_exponent = 20.0;
  return steel;
}

/// A rising test in four points; the first ends the straight part.
SteelDescription tested_steel() {
  SteelDescription steel = make_steel(MaterialLaw::stress_strain);
  steel.material.stress_strain = {{0.0018, 372.6e6}, {0.004, 420e6}, {0.01, 460e6}, {0.02, 480e6}};
  return steel;
}

double total_strain(const SteelDescription& steel, double stress) {
  return stress / steel.youngs_modulus + plastic_strain(steel).at(stress).value;
}

TEST(plastic_strain, power_law_reaches_the_yield_strain_at_smys) {
  const SteelDescription steel = make_steel(MaterialLaw::ramberg_osgood);
  EXPECT_NEAR(total_strain(steel, kYield), steel.material.yield_strain, 1e-15);
}

TEST(plastic_strain, of_a_test_passes_through_its_points) {
  const SteelDescription steel = tested_steel();
  for (const CurvePoint& point : steel.material.stress_strain) {
    EXPECT_NEAR(total_strain(steel, point.y), point.x, 1e-15);
  }
}

TEST(plastic_strain, of_a_test_goes_on_along_its_last_stretch) {
  const SteelDescription steel = tested_steel();
  const double slope = (0.02 - 0.01) / 20e6;  // of the total strain between the last two points
  EXPECT_NEAR(total_strain(steel, 490e6), 0.02 + slope * 10e6, 1e-12);
}

TEST(plastic_strain, is_none_below_the_first_point) {
  const SteelDescription steel = tested_steel();
  EXPECT_EQ(plastic_strain(steel).at(372e6).value, 0.0);
  EXPECT_EQ(plastic_strain(steel).at(372e6).slope, 0.0);
}

TEST(plastic_strain, bilinear_steel_has_its_hardening_modulus_beyond_smys) {
  SteelDescription steel = make_steel(MaterialLaw::bilinear);
  steel.material.hardening_modulus = 2e9;
  EXPECT_NEAR(total_strain(steel, kYield + 10e6), kYield / kModulus + 10e6 / 2e9, 1e-15);
}

// Central differences of step h err by h^2 times the third derivative; 1e-5 of the slope leaves room for rounding.
TEST(plastic_strain, slope_is_the_derivative) {
  for (const SteelDescription& steel : {make_steel(MaterialLaw::ramberg_osgood), tested_steel()}) {
    const PlasticStrain plastic = plastic_strain(steel);
    for (const double stress : {390e6, 430e6, 470e6}) {
      const double h = 1e-4 * stress;
      const double slope = (plastic.at(stress + h).value - plastic.at(stress - h).value) / (2.0 * h);
      EXPECT_NEAR(plastic.at(stress).slope / slope, 1.0, 1e-5) << stress;
    }
  }
}

// The table has 240 intervals each way, finest at zero, with cubics between.
TEST(fibre_curve, without_hoop_stress_turns_the_law_round) {
  const SteelDescription steel = make_steel(MaterialLaw::ramberg_osgood);
  const FibreCurve fibre(steel, plastic_strain(steel), 0.0, 0.03);
  for (const double strain : {1e-4, 1e-3, 2e-3, 5e-3, 0.01, 0.029}) {
    EXPECT_NEAR(total_strain(steel, fibre.at(strain).stress) / strain, 1.0, 1e-4) << strain;
    EXPECT_NEAR(fibre.at(-strain).stress, -fibre.at(strain).stress, 1e-6 * kYield) << strain;
  }
}

TEST(fibre_curve, modulus_is_the_derivative_of_the_stress) {
  const SteelDescription steel = make_steel(MaterialLaw::ramberg_osgood);
  const FibreCurve fibre(steel, plastic_strain(steel), 100e6, 0.03);
  for (const double strain : {-0.04, -0.01, -1.5e-3, 1.5e-3, 0.004, 0.02, 0.04}) {
    const double h = 1e-7;
    const double slope = (fibre.at(strain + h).stress - fibre.at(strain - h).stress) / (2.0 * h);
    EXPECT_NEAR(fibre.at(strain).modulus / slope, 1.0, 1e-4) << strain;
  }
}

// Steel that hardly hardens flows on von Mises' ellipse: s^2 - s h + h^2 = SMYS^2.
TEST(fibre_curve, hoop_stress_moves_the_yield_stress_along_von_mises_ellipse) {
  SteelDescription steel = make_steel(MaterialLaw::bilinear);
  steel.material.hardening_modulus = 0.0;
  for (const double hoop : {-200e6, -100e6, 150e6}) {
    const FibreCurve fibre(steel, plastic_strain(steel), hoop, 0.03);
    const double root = std::sqrt(kYield * kYield - 0.75 * hoop * hoop);
    EXPECT_NEAR(fibre.at(0.01).stress, 0.5 * hoop + root, 1e-3 * kYield) << hoop;
    EXPECT_NEAR(fibre.at(-0.01).stress, 0.5 * hoop - root, 1e-3 * kYield) << hoop;
  }
}

// Strain counts from where the hoop stress alone leaves the fibre, so that there the axial stress is none.
TEST(fibre_curve, carries_no_axial_stress_at_no_strain) {
  const SteelDescription steel = make_steel(MaterialLaw::ramberg_osgood);
  const FibreCurve fibre(steel, plastic_strain(steel), 150e6, 0.03);
  EXPECT_EQ(fibre.at(0.0).stress, 0.0);
}

}  // namespace
}  // namespace overbend
