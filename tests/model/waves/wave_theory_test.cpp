#include "model/waves/wave_theory.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "base/constants.h"
#include "model/pipe/section.h"

namespace overbend {
namespace {

TEST(wave_theory, the_dispersion_relation_holds_to_machine_precision) {
  for (const double depth : {0.5, 5.0, 89.0, 1000.0, 12000.0}) {
    for (const double period : {0.5, 2.0, 8.0, 20.0, 100.0, 1000.0}) {
      const double omega = 2.0 * kPi / period, k = linear_wave_number(omega, depth);
      EXPECT_NEAR(kGravity * k * std::tanh(k * depth) / (omega * omega), 1.0, 2e-15) << depth << ' ' << period;
    }
  }
  EXPECT_EQ(linear_wave_number(0.0, 50.0), 0.0);
}

TEST(wave_theory, wave_numbers_have_their_deep_and_shallow_limits) {
  EXPECT_DOUBLE_EQ(linear_wave_number(1.0, 5000.0), 1.0 / kGravity);
  const double omega = 1e-3, depth = 10.0;
  EXPECT_NEAR(linear_wave_number(omega, depth) * std::sqrt(kGravity * depth) / omega,
              1.0 + omega * omega * depth / kGravity / 6.0, 1e-12);
}

TEST(wave_theory, stokes_coefficients_are_those_of_the_published_table) {
  // [fenton1985], table 2: values for k d = 0.753982, to the digits printed. k d itself is printed to six digits, which
  // the steepest of them turn into 5e-6 of their value.
  const double kd = 0.753982;
  const StokesCoefficients c = stokes_coefficients(kd);
  const auto agree = [](double ours, double printed) { EXPECT_NEAR(ours, printed, 6e-6 * std::abs(printed) + 6e-7); };
  agree(c.a11 / std::cosh(kd), 1.208490);
  agree(c.a22 / std::cosh(2 * kd), 0.799840);
  agree(c.a31 / std::cosh(kd), -9.105340);
  agree(c.a33 / std::cosh(3 * kd), 0.368275);
  agree(c.a42 / std::cosh(2 * kd), -12.196150);
  agree(c.a44 / std::cosh(4 * kd), 0.058723);
  agree(c.a51 / std::cosh(kd), 108.467921);
  agree(c.a53 / std::cosh(3 * kd), -6.941756);
  agree(c.a55 / std::cosh(5 * kd), -0.074979);
  agree(c.b22, 2.502414);
  agree(c.b31, -5.731666);
  agree(c.b42, -32.407508);
  agree(c.b44, 14.033758);
  agree(c.b53, -103.445042);
  agree(c.b55, 37.200027);
  agree(c.c0, 0.798448);
  agree(c.c2, 1.940215);
  agree(c.c4, -12.970403);
}

TEST(wave_theory, stokes_coefficients_pass_smoothly_into_deep_water) {
  const StokesCoefficients limit = stokes_coefficients(1e6), before = stokes_coefficients(17.9);
  EXPECT_NEAR(limit.a31, -0.5, 1e-14);
  EXPECT_NEAR(limit.a42, 0.5, 1e-14);
  EXPECT_NEAR(limit.a51, -37.0 / 24.0, 1e-14);
  EXPECT_NEAR(limit.a53, 1.0 / 12.0, 1e-14);
  EXPECT_NEAR(limit.a22, 0.0, 1e-14);
  EXPECT_NEAR(limit.b55, 125.0 / 384.0, 1e-14);
  EXPECT_NEAR(limit.c2, 0.5, 1e-14);
  EXPECT_NEAR(limit.c4, 0.125, 1e-14);
  EXPECT_NEAR(before.a51, limit.a51, 1e-12);
  EXPECT_NEAR(before.b53, limit.b53, 1e-12);
}

TEST(wave_theory, the_stokes_wave_number_is_that_of_fentons_program) {
  // Wave of height 0.3 d and length 8 d: his fifth-order program prints the period 8.5184 sqrt(d/g).
  const double depth = 25.0, period = 8.5184 * std::sqrt(depth / kGravity);
  EXPECT_NEAR(2.0 * kPi / stokes_wave_number(0.3 * depth, period, depth), 8.0 * depth, 8.0 * depth * 1e-5);
}

TEST(wave_theory, low_stokes_waves_have_the_linear_wave_number) {
  for (const double depth : {10.0, 60.0, 500.0}) {
    EXPECT_NEAR(stokes_wave_number(1e-4, 7.0, depth) / linear_wave_number(2.0 * kPi / 7.0, depth), 1.0, 1e-9);
  }
}

TEST(wave_theory, an_impossible_stokes_wave_is_rejected) {
  EXPECT_THROW(stokes_wave_number(50.0, 4.0, 5.0), std::domain_error);
}

TEST(wave_theory, the_highest_wave_has_its_known_limits) {
  EXPECT_NEAR(highest_wave(8.0, 1.0), 0.678, 5e-4);    // as Fenton's program prints it
  EXPECT_NEAR(highest_wave(1.0, 100.0), 0.141, 1e-3);  // deep: 0.141 L
  EXPECT_NEAR(highest_wave(1e5, 1.0), 0.833, 1e-3);    // solitary wave
}

}  // namespace
}  // namespace overbend
