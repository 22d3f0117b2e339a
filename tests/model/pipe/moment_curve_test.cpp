#include "model/pipe/moment_curve.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "model/pipe/bending_law.h"

namespace overbend {
namespace {

SteelDescription sixteen_inch_x60(double n) {
  SteelDescription steel{0.4064, 0.011125, 207e9, 0.3, 414e6, 517e6, 77e3, {}};
  steel.material.law = MaterialLaw::ramberg_osgood;
  steel.material.hardening_exponent = n;
  return steel;
}

SteelDescription thin_bilinear() {
  SteelDescription steel{1.0, 0.0005, 200e9, 0.3, 400e6, std::nullopt, 77e3, {}};
  steel.material.law = MaterialLaw::bilinear;
  return steel;
}

/// A thin ring of elastic, perfectly plastic steel: its moment over that at first yield, the yielded part beginning at
/// the angle asin(k_y/k) from the neutral axis.
double thin_ring_moment(double k) {
  if (k <= 1.0) return k;
  const double a = std::asin(1.0 / k);
  return 4.0 / std::numbers::pi * ((0.5 * a - 0.25 * std::sin(2.0 * a)) * k + std::cos(a));
}

// Fibre integration of the same stress-strain law by an independent program, 20 x 720 fibres.
TEST(moment_curve, sixteen_inch_pipe_agrees_with_a_fibre_integration) {
  const SteelDescription steel = sixteen_inch_x60(25.0);
  const FirstYield yield = first_yield(steel);
  EXPECT_NEAR(yield.moment, 550.15e3, 5.0);
  EXPECT_NEAR(yield.curvature, 0.009843, 5e-7);
  constexpr std::array<std::array<double, 2>, 5> kTable = {
      {{1.014, 0.9696}, {1.827, 1.1882}, {2.641, 1.2552}, {3.454, 1.2899}, {4.268, 1.3123}}};
  const WallIntegral fine(steel, {}, 5.0 * yield.curvature, 720, 20), coarse(steel, {}, 5.0 * yield.curvature);
  for (const auto& [k, m] : kTable) {
    // The curvature is printed to half a thousandth, which moves the moment by up to 3e-4 at the first point.
    EXPECT_NEAR(fine.at(k * yield.curvature).moment / yield.moment, m, 3e-4) << k;
    EXPECT_NEAR(coarse.at(k * yield.curvature).moment / yield.moment, m, 5e-4) << k;
  }
}

/// Largest difference of two moment laws, relative, from first yield to four times its curvature.
double difference(const MomentRambergOsgood& a, const MomentRambergOsgood& b) {
  double worst = 0.0;
  for (double k = 1.0; k <= 4.0; k += 0.1) {
    worst = std::max(worst, std::abs(relative_moment(a, k) / relative_moment(b, k) - 1.0));
  }
  return worst;
}

// The published coefficients were fitted over a range that is not given; A and B trade against each other (0.064 and
// 13.7 here for 0.056 and 14.5), the curves may not differ by more than either differs from the fibres.
TEST(moment_curve, fit_of_the_moment_form_is_the_published_curve) {
  const MomentRambergOsgood n25 = fit_moment_law(sixteen_inch_x60(25.0)), n15 = fit_moment_law(sixteen_inch_x60(15.0));
  EXPECT_LT(difference(n25, {0.056, 14.5}), 0.012);
  EXPECT_LT(difference(n15, {0.133, 11.0}), 0.012);
  EXPECT_LT(n25.max_error, 0.012);
  EXPECT_LT(n15.max_error, 0.012);
}

TEST(moment_curve, first_yield_of_the_24_inch_pipe) {
  const FirstYield yield = first_yield({0.6096, 0.0254, 207e9, 0.3, 448e6, 531e6, 77e3, {}});
  EXPECT_NEAR(yield.moment, 2928.61e3, 5.0);
  EXPECT_NEAR(yield.curvature, 0.007101, 5e-7);
}

TEST(moment_curve, thin_bilinear_ring_follows_the_closed_form) {
  const SteelDescription steel = thin_bilinear();
  const FirstYield yield = first_yield(steel);
  const WallIntegral wall(steel, {}, 10.0 * yield.curvature, 400);
  for (const double k : {0.5, 1.0, 1.2, 2.0, 5.0, 10.0}) {
    // The wall is a two-thousandth of the diameter thick, and perfect plasticity keeps 1e-5 of the modulus.
    EXPECT_NEAR(wall.at(k * yield.curvature).moment / yield.moment, thin_ring_moment(k), 2e-3) << k;
  }
}

// Thin ring, fully plastic: M/M_p = cos(pi/2 N/N_p).
TEST(moment_curve, tension_takes_its_share_of_the_plastic_moment) {
  const SteelDescription steel = thin_bilinear();
  const double plastic_force = steel.yield_stress * std::numbers::pi * (1.0 - 0.0005) * 0.0005;
  const FirstYield yield = first_yield(steel);
  const double far = 200.0 * yield.curvature;
  const double alone = WallIntegral(steel, {}, far, 400).at(far).moment;
  for (const double share : {0.1, 0.3, 0.6}) {
    const double with = WallIntegral(steel, {share * plastic_force, 0.0}, far, 400).at(far).moment;
    EXPECT_NEAR(with / alone, std::cos(0.5 * std::numbers::pi * share), 3e-3) << share;
  }
}

// Von Mises: next to a hoop stress h steel yields axially at h/2 +- sqrt(fy^2 - 3/4 h^2).
TEST(moment_curve, hoop_stress_shifts_both_axial_yield_stresses) {
  const SteelDescription steel = thin_bilinear();
  const double hoop = -200e6, root = std::sqrt(400e6 * 400e6 - 0.75 * hoop * hoop);
  const FibreCurve fibre(steel, plastic_strain(steel), hoop, 0.05);
  EXPECT_NEAR(fibre.at(0.04).stress, 0.5 * hoop + root, 5e-3 * root);
  EXPECT_NEAR(fibre.at(-0.04).stress, 0.5 * hoop - root, 5e-3 * root);
  EXPECT_NEAR(fibre.at(1e-4).stress, 200e9 * 1e-4, 1e3);  // elastic from where it lies under the hoop stress
}

TEST(bending_law, springs_follow_the_wall_under_a_growing_load) {
  const SteelDescription steel = sixteen_inch_x60(25.0);
  const FirstYield yield = first_yield(steel);
  const WallLoads loads{300e3, -20e6};
  const BendingLaw law = bending_law(steel, {{0.0, loads}}).value();
  const WallIntegral wall(steel, loads, 10.0 * yield.curvature);
  for (double k = 0.2; k < 8.0; k *= 1.13) {
    const double exact = wall.at(k * yield.curvature).moment;
    EXPECT_NEAR(monotonic(law, {}, k * yield.curvature).moment / exact, 1.0, 1.05 * law.fit_error) << k;
  }
  EXPECT_LT(law.fit_error, 4e-3);  // what eight sliders make of a curve this round
}

TEST(bending_law, table_is_followed) {
  SteelDescription steel = sixteen_inch_x60(25.0);
  steel.material.law = MaterialLaw::moment_curvature;
  const double EI = 207e9 * second_moment(0.4064, 0.011125);
  steel.material.moment_curvature = {{400e3 / EI, 400e3}, {0.012, 520e3}, {0.03, 600e3}};
  const BendingLaw law = bending_law(steel, {}).value();
  for (const CurvePoint& point : steel.material.moment_curvature) {
    EXPECT_NEAR(monotonic(law, {}, point.x).moment, point.y, 1.05 * law.fit_error * point.y);
  }
  EXPECT_NEAR(monotonic(law, {}, 0.5 * 400e3 / EI).moment, 200e3, 1e-3);
  EXPECT_LT(law.fit_error, 0.03);  // a round wall rounds the corners of three points; the report gives the error
}

TEST(bending_law, levels_are_mixed_by_height) {
  const SteelDescription steel = sixteen_inch_x60(25.0);
  const BendingLaw law = bending_law(steel, {{-100.0, {2000e3, 0.0}}, {0.0, {0.0, 0.0}}}).value();
  const auto moment = [&](double z) { return monotonic(law, level_at(law, z), 0.02).moment; };
  EXPECT_LT(moment(-100.0), 0.99 * moment(0.0));
  EXPECT_NEAR(moment(-50.0), 0.5 * (moment(-100.0) + moment(0.0)), 1.0);
  EXPECT_EQ(moment(-500.0), moment(-100.0));
  EXPECT_EQ(moment(50.0), moment(0.0));
}

}  // namespace
}  // namespace overbend
