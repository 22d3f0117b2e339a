#include "hull/hull_current.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "hull/hull_wind.h"

namespace overbend {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kDeg = kPi / 180.0;

HullCurrent strips(double towards, double speed) {
  HullCurrent c;
  c.form = HullCurrentForm::strips;
  c.velocity = speed * Eigen::Vector2d(std::cos(towards), std::sin(towards));
  c.length = 120.0;
  c.beam = 30.0;
  c.draught = 5.182;
  c.reference_V = Vec3(1.0, 0.0, 0.818);
  c.transverse = 0.8;
  c.longitudinal = 0.5;
  c.wetted_surface = 5155.0;
  return c;
}

/// A lopsided table.
HullCurrent table() {
  HullCurrent c = strips(50.0 * kDeg, 1.3);
  c.form = HullCurrentForm::table;
  c.frontal_area = 155.0;
  c.lateral_area = 620.0;
  c.table_length = 120.0;
  for (int i = 0; i < 12; ++i) {
    const double a = 30.0 * i * kDeg;
    c.table.push_back({a, 0.7 * std::cos(a) + 0.1, 0.9 * std::sin(a), 0.1 * std::sin(2.0 * a) + 0.02});
  }
  return c;
}

TEST(hull_current, on_the_beam_gives_the_forces_of_plain_drag) {
  // 1/2 rho C L T V^2: 146, 265 and 398 kN for 0.44, 0.8 and 1.2 at 1.02 m/s.
  for (const auto& [coefficient, force] : {std::pair{0.44, 145.9}, {0.8, 265.3}, {1.2, 397.9}}) {
    HullCurrent c = strips(90.0 * kDeg, 1.02);
    c.transverse = coefficient;
    const Vec6 f = current_force(c, 0.0, Vec6::Zero(), {}).force;
    EXPECT_NEAR(f(1) / 1e3, force, 0.1);
    // At half the draught and at midship, 1 m astern of the reference point.
    EXPECT_NEAR(f(3), f(1) * (0.5 * 5.182 + 0.818), 1e-6);
    EXPECT_NEAR(f(5), -f(1) * 1.0, 1e-6);
  }
}

TEST(hull_current, ahead_gives_form_drag_and_the_friction_line) {
  const HullCurrent c = strips(0.0, 1.0);
  const double reynolds = 1.0 * 120.0 / 1.19e-6, line = 0.075 / std::pow(std::log10(reynolds) - 2.0, 2);
  const double expected = 0.5 * 1025.0 * (30.0 * 5.182 * 0.5 + 5155.0 * line);
  EXPECT_NEAR(current_force(c, 0.0, Vec6::Zero(), {}).force(0), expected, 1e-6 * expected);
}

TEST(hull_current, derivatives_agree_with_differences) {
  StripWater waves;
  for (std::size_t i = 0; i < kHullStrips; ++i) {
    waves.along[i] = 0.3 * std::sin(1.0 + static_cast<double>(i));
    waves.across[i] = 0.4 * std::cos(2.0 * static_cast<double>(i));
  }
  const Vec6 v = (Vec6() << 0.35, -0.28, 0.1, 0.02, -0.013, 0.004).finished();
  for (const HullCurrent& c : {strips(70.0 * kDeg, 0.9), table()}) {
    const CurrentForce exact = current_force(c, 0.2, v, waves);
    const double d = 1e-6;
    for (int k = 0; k < 6; ++k) {
      const Vec6 e = d * Vec6::Unit(k);
      const Vec6 slope =
          (current_force(c, 0.2, v + e, waves).force - current_force(c, 0.2, v - e, waves).force) / (2.0 * d);
      EXPECT_LT((exact.by_v.col(k) - slope).norm(), 1e-6 * exact.by_v.norm()) << k;
    }
  }
}

TEST(hull_current, a_hull_that_goes_with_the_water_feels_nothing) {
  const HullCurrent c = strips(30.0 * kDeg, 0.8);
  Vec6 v = Vec6::Zero();
  v(0) = 0.8 * std::cos(30.0 * kDeg);
  v(1) = 0.8 * std::sin(30.0 * kDeg);
  EXPECT_LT(current_force(c, 0.0, v, {}).force.norm(), 1e-9);
}

TEST(hull_current, takes_energy_out_of_any_motion_in_still_water) {
  HullCurrent c = strips(0.0, 0.0);
  for (const Vec6& v :
       {Vec6(Vec6::Unit(5) * 0.01), Vec6(Vec6::Unit(1)), Vec6((Vec6() << 1, -1, 0, 0.1, 0.1, 0.02).finished())}) {
    EXPECT_LT(current_force(c, 0.0, v, {}).force.dot(v), 0.0);
  }
}

TEST(hull_current, table_turns_with_the_hull_and_is_linear_between_its_rows) {
  const HullCurrent c = table();
  // Towards 50 deg, the hull heads -55: 105 deg from the bow, half way between two rows.
  const Vec6 f = current_force(c, -55.0 * kDeg, Vec6::Zero(), {}).force;
  const double size = 0.5 * 1025.0 * 1.3 * 1.3;
  const double cy = 0.5 * (c.table[3].cy + c.table[4].cy), cz = 0.5 * (c.table[3].cz + c.table[4].cz);
  EXPECT_NEAR(f(1), size * 620.0 * cy, 1e-6);
  EXPECT_NEAR(f(5), size * 620.0 * 120.0 * cz - 1.0 * f(1), 1e-6);
}

TEST(hull_current, conventions_of_a_table_name_one_and_the_same_flow) {
  // A flow that runs to port: from starboard. Clockwise from the bow that is 90 deg; OCIMF's 90 deg too.
  const CoefficientRow row{90.0 * kDeg, 0.0, 0.9, 0.1};
  for (const CoefficientAxes axes :
       {CoefficientAxes::to_from_bow, CoefficientAxes::from_bow, CoefficientAxes::from_stern_ocimf}) {
    EXPECT_NEAR(coefficients_from_bow({row}, axes)[0].angle, 90.0 * kDeg, 1e-12);
  }
  // A flow from ahead: 180 deg for OCIMF, 0 from the bow, towards 180.
  EXPECT_NEAR(coefficients_from_bow({{0.0, -0.1, 0.0, 0.0}}, CoefficientAxes::from_bow)[0].angle, kPi, 1e-12);
  EXPECT_NEAR(coefficients_from_bow({{kPi, -0.1, 0.0, 0.0}}, CoefficientAxes::from_stern_ocimf)[0].angle, kPi, 1e-12);
}

TEST(hull_current, shallow_water_coefficient_of_bgl1) {
  EXPECT_NEAR(ufc_transverse_coefficient(120.0, 30.0, 5.182, 30.0 * 5.182, 18655.2, 89.0), 0.45, 0.005);
}

TEST(hull_wind, pushes_areas_at_their_centres) {
  HullWind wind;
  wind.velocity = {0.0, 20.0};  // north
  wind.reference_V = Vec3(0.0, 0.0, 0.8);
  wind.areas = {{"side", 400.0, Vec3(10.0, 0.0, 4.8), 1.0, 1.0, false},
                {"front", 100.0, Vec3(0.0, 0.0, 5.0), 1.25, 1.1, true}};
  const double q = 0.5 * 1.226 * 400.0;
  const Vec6 beam = wind_force(wind, 0.0);  // heading east: on the side
  EXPECT_NEAR(beam(1), q * 400.0, 1e-9);
  EXPECT_NEAR(beam(3), -q * 400.0 * 4.0, 1e-8);
  EXPECT_NEAR(beam(5), q * 400.0 * 10.0, 1e-8);
  EXPECT_NEAR(beam(0), 0.0, 1e-9);
  const Vec6 astern = wind_force(wind, 0.5 * kPi);  // heading north
  EXPECT_NEAR(astern(0), q * 1.25 * 1.1 * 100.0, 1e-8);
  EXPECT_NEAR(astern(1), 0.0, 1e-8);
}

}  // namespace
}  // namespace overbend
