#include "hull/hull_current.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/constants.h"
#include "hull/hull_wind.h"

namespace overbend {
namespace {

HullCurrent strips(double towards, double speed) {
  HullCurrent c;
  c.form = HullCurrentModel::strips;
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

/// The same hull by UFC 4-159-03.
HullCurrent ufc(double towards, double speed) {
  HullCurrent c = strips(towards, speed);
  c.form = HullCurrentModel::ufc;
  c.transverse = 0.45;
  c.longitudinal = kUfcFormDrag;
  c.wetted_surface = 4656.0;
  return c;
}

/// A lopsided table.
HullCurrent table() {
  HullCurrent c = strips(50.0 * kDegree, 1.3);
  c.form = HullCurrentModel::table;
  c.table = {155.0, 620.0, 120.0, {}};
  for (int i = 0; i < 12; ++i) {
    const double a = 30.0 * i * kDegree;
    c.table.rows.push_back({a, 0.7 * std::cos(a) + 0.1, 0.9 * std::sin(a), 0.1 * std::sin(2.0 * a) + 0.02});
  }
  return c;
}

TEST(hull_current, on_the_beam_gives_the_forces_of_plain_drag) {
  // 1/2 rho C L T V^2: 146, 265 and 398 kN for 0.44, 0.8 and 1.2 at 1.02 m/s.
  for (const auto& [coefficient, force] : {std::pair{0.44, 145.9}, {0.8, 265.3}, {1.2, 397.9}}) {
    HullCurrent c = strips(90.0 * kDegree, 1.02);
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
  for (const HullCurrent& c : {strips(70.0 * kDegree, 0.9), ufc(70.0 * kDegree, 0.9), table()}) {
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
  const HullCurrent c = strips(30.0 * kDegree, 0.8);
  Vec6 v = Vec6::Zero();
  v(0) = 0.8 * std::cos(30.0 * kDegree);
  v(1) = 0.8 * std::sin(30.0 * kDegree);
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
  const Vec6 f = current_force(c, -55.0 * kDegree, Vec6::Zero(), {}).force;
  const double size = 0.5 * 1025.0 * 1.3 * 1.3;
  const double cy = 0.5 * (c.table.rows[3].cy + c.table.rows[4].cy),
               cz = 0.5 * (c.table.rows[3].cz + c.table.rows[4].cz);
  EXPECT_NEAR(f(1), size * 620.0 * cy, 1e-6);
  EXPECT_NEAR(f(5), size * 620.0 * 120.0 * cz - 1.0 * f(1), 1e-6);
}

TEST(hull_current, conventions_of_a_table_name_one_and_the_same_flow) {
  // A flow that runs to port: from starboard. Clockwise from the bow that is 90 deg; OCIMF's 90 deg too.
  const CoefficientRow row{90.0 * kDegree, 0.0, 0.9, 0.1};
  for (const CoefficientAxes axes :
       {CoefficientAxes::to_from_bow, CoefficientAxes::from_bow, CoefficientAxes::from_stern_ocimf}) {
    EXPECT_NEAR(coefficients_from_bow({row}, axes)[0].angle, 90.0 * kDegree, 1e-12);
  }
  // A flow from ahead: 180 deg for OCIMF, 0 from the bow, towards 180.
  EXPECT_NEAR(coefficients_from_bow({{0.0, -0.1, 0.0, 0.0}}, CoefficientAxes::from_bow)[0].angle, kPi, 1e-12);
  EXPECT_NEAR(coefficients_from_bow({{kPi, -0.1, 0.0, 0.0}}, CoefficientAxes::from_stern_ocimf)[0].angle, kPi, 1e-12);
}

TEST(hull_current, coefficients_of_bgl1_by_its_dimensions) {
  const UfcHull bgl1{120.0, 30.0, 5.182, 30.0 * 5.182, 18655.2};
  // chi = L^2 A_m / (B V) = 4.0 and C0 = 0.22 sqrt(chi) = 0.44, that of deep water.
  EXPECT_NEAR(ufc_transverse_coefficient(bgl1, 1e9), 0.44, 1e-4);
  EXPECT_NEAR(ufc_transverse_coefficient(bgl1, 89.0), 0.45, 0.001);
  EXPECT_NEAR(ufc_transverse_coefficient(bgl1, 5.182), 3.2, 1e-9);  // none passes under the keel
  EXPECT_NEAR(ufc_wetted_surface(bgl1), 1.7 * 5.182 * 120.0 + 18655.2 / 5.182, 1e-6);
}

TEST(hull_current, by_the_hulls_dimensions_follows_sine_and_cosine_of_the_angle) {
  // UFC 4-159-03, equations 14 to 20: F_y = q L T C_yc sin, F_x = q B T 0.1 cos + q S C_f(V L cos / nu) cos.
  for (const double angle : {0.0, 30.0, 70.0, 90.0, 135.0, 260.0}) {
    const HullCurrent c = ufc(angle * kDegree, 0.9);
    const Vec6 f = current_force(c, 0.0, Vec6::Zero(), {}).force;
    const double q = 0.5 * 1025.0 * 0.9 * 0.9, along = std::cos(angle * kDegree), across = std::sin(angle * kDegree);
    const double reynolds = std::max(0.9 * 120.0 * std::abs(along) / 1.19e-6, 1e5);
    const double friction = 0.075 / std::pow(std::log10(reynolds) - 2.0, 2);
    EXPECT_NEAR(f(1), q * 120.0 * 5.182 * 0.45 * across, 1e-6) << angle;
    EXPECT_NEAR(f(0), q * (30.0 * 5.182 * 0.1 + 4656.0 * friction) * along, 1e-6) << angle;
  }
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

TEST(hull_wind, by_a_table_is_that_of_its_row) {
  HullWind wind;
  wind.velocity = {0.0, 20.0};  // north
  wind.reference_V = Vec3(2.0, 0.0, 0.8);
  wind.table = {115.0, 460.0, 120.0, {{0.0, 0.7, 0.0, 0.0}, {0.5 * kPi, 0.1, 0.9, 0.05}, {kPi, -0.7, 0.0, 0.0}}};
  const double q = 0.5 * 1.226 * 400.0;
  const Vec6 f = wind_force(wind, 0.0);  // heading east: to port
  EXPECT_NEAR(f(0), q * 115.0 * 0.1, 1e-9);
  EXPECT_NEAR(f(1), q * 460.0 * 0.9, 1e-9);
  EXPECT_NEAR(f(5), q * 460.0 * (120.0 * 0.05 - 2.0 * 0.9), 1e-8);
}

}  // namespace
}  // namespace overbend
