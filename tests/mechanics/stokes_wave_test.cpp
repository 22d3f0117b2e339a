#include "mechanics/stokes_wave.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/constants.h"
#include "mechanics/sea.h"
#include "model/pipe/section.h"
#include "model/waves/wave_theory.h"

namespace overbend {
namespace {

/// Period of the Stokes wave of a given steepness e = k H/2 and k d in a depth of 1 m, and the wave itself.
StokesWave make_wave(double steepness, double kd) {
  const StokesCoefficients c = stokes_coefficients(kd);
  const double e2 = steepness * steepness;
  const double omega = std::sqrt(kGravity * kd) * (c.c0 + e2 * (c.c2 + e2 * c.c4));
  return stokes_wave(2.0 * steepness / kd, 2.0 * kPi / omega, 1.0, 1.0, 0.0, 0.0);
}

struct SurfaceErrors {
  double kinematic = 0.0, dynamic = 0.0;  // over c and over g/k
};

/// Distance of the surface from a streamline of constant pressure, in the frame that travels with the wave.
SurfaceErrors surface_errors(const StokesWave& wave) {
  const double k = wave.wave_number, speed = wave.omega / k;
  constexpr int kPlaces = 64;
  double mean = 0.0;
  std::array<double, kPlaces> head{};
  SurfaceErrors errors;
  for (int i = 0; i < kPlaces; ++i) {
    const double phase = 2.0 * kPi * i / kPlaces, eta = elevation(wave, 0.0, phase / k, 0.0);
    double slope = 0.0;
    for (int j = 1; j <= 5; ++j) slope -= j * k * wave.elevation[j - 1] * std::sin(j * phase);
    const Vec3 v = kinematics(wave, 0.0, phase / k, 0.0, eta).velocity - speed * Vec3::UnitX();
    errors.kinematic = std::max(errors.kinematic, std::abs(v.z() - v.x() * slope) / speed);
    head[i] = (0.5 * v.squaredNorm() + kGravity * eta) * k / kGravity;
    mean += head[i] / kPlaces;
  }
  for (const double h : head) errors.dynamic = std::max(errors.dynamic, std::abs(h - mean));
  return errors;
}

TEST(stokes_wave, the_surface_conditions_are_met_to_fifth_order) {
  // The remainder falls with the sixth power of the steepness: halving it divides the error by 64.
  for (const double kd : {1.0, 1.5, 3.0, 30.0}) {
    const double e = kd < 1.2 ? 0.02 : 0.05;  // the coefficients grow towards shallow water
    const SurfaceErrors high = surface_errors(make_wave(e, kd)), low = surface_errors(make_wave(0.5 * e, kd));
    EXPECT_GT(std::log2(high.kinematic / low.kinematic), 5.8) << kd;
    EXPECT_GT(std::log2(high.dynamic / low.dynamic), 5.8) << kd;
  }
}

TEST(stokes_wave, a_steep_wave_of_deep_water_still_meets_the_surface_conditions) {
  const SurfaceErrors errors = surface_errors(make_wave(0.25, 20.0));  // H/L = 0.08
  EXPECT_LT(errors.kinematic, 3e-3);
  EXPECT_LT(errors.dynamic, 3e-3);
}

/// The wave that Fenton's program was run for: H = 0.3 d, L = 8 d; lengths in d, speeds in sqrt(g d).
class PrintedWave : public ::testing::Test {
 protected:
  const double depth = 20.0, speed = std::sqrt(kGravity * depth);
  const StokesWave wave = stokes_wave(0.3 * depth, 8.5184 * std::sqrt(depth / kGravity), depth, 1.0, 0.0, 0.0);
};

TEST_F(PrintedWave, has_the_printed_surface) {
  // Amplitudes of the surface's harmonics times k. The period is known to five digits.
  const double printed[] = {1.1085623e-1, 2.7030818e-2, 6.3316832e-3, 2.1243859e-3, 6.2180771e-4};
  for (int j = 0; j < 5; ++j) EXPECT_NEAR(wave.elevation[j] * wave.wave_number / printed[j], 1.0, 2e-4) << j + 1;
}

TEST_F(PrintedWave, has_the_printed_velocities_and_accelerations) {
  // x, height over the bed, u, v, du/dt, dv/dt (in g); to the four digits printed.
  const double rows[][6] = {{0.0, 0.0, 0.1290, 0.0, 0.0, 0.0},
                            {0.0, 1.0087, 0.1921, 0.0, 0.0, -0.1323},
                            {0.0, 1.1867, 0.2207, 0.0, 0.0, -0.1708},
                            {1.0, 0.5456, 0.0870, 0.0501, 0.0963, -0.0239},
                            {1.0, 1.0911, 0.1080, 0.1195, 0.1511, -0.0482},
                            {2.0, 0.9683, -0.0330, 0.0910, 0.0995, 0.0440},
                            {3.0, 0.4517, -0.0849, 0.0194, 0.0400, 0.0199},
                            {4.0, 0.8875, -0.1171, 0.0, 0.0, 0.0324}};
  for (const auto& row : rows) {
    const WaveKinematics k = kinematics(wave, 0.0, row[0] * depth, 0.0, (row[1] - 1.0) * depth);
    EXPECT_NEAR(k.velocity.x() / speed, row[2], 8e-5);
    EXPECT_NEAR(k.velocity.z() / speed, row[3], 8e-5);
    EXPECT_NEAR(k.acceleration.x() / kGravity, row[4], 8e-5);
    EXPECT_NEAR(k.acceleration.z() / kGravity, row[5], 8e-5);
  }
}

TEST_F(PrintedWave, keeps_volume_has_no_spin_and_accelerates_as_it_should) {
  const double h = 1e-4, x = 13.0, z = -7.0, t = 0.8;
  const auto sample = [&](double dt, double dx, double dz) {
    return kinematics(wave, t + dt, x + dx, 0.0, z + dz).velocity;
  };
  const Vec3 by_x = (sample(0, h, 0) - sample(0, -h, 0)) / (2 * h),
             by_z = (sample(0, 0, h) - sample(0, 0, -h)) / (2 * h);
  EXPECT_NEAR(by_x.x() + by_z.z(), 0.0, 1e-9);
  EXPECT_NEAR(by_x.z() - by_z.x(), 0.0, 1e-9);
  const Vec3 by_t = (sample(h, 0, 0) - sample(-h, 0, 0)) / (2 * h);
  EXPECT_LT((kinematics(wave, t, x, 0.0, z).acceleration - by_t).norm(), 1e-8);
}

TEST_F(PrintedWave, has_its_height_from_trough_to_crest_and_no_mean_elevation) {
  const double half = kPi / wave.wave_number;
  EXPECT_NEAR(elevation(wave, 0.0, 0.0, 0.0) - elevation(wave, 0.0, half, 0.0), 0.3 * depth, 1e-12 * depth);
  double mean = 0.0;
  for (int i = 0; i < 16; ++i) mean += elevation(wave, 0.0, half * i / 8.0, 0.0) / 16;
  EXPECT_NEAR(mean, 0.0, 1e-13 * depth);
}

WavesDescription description(WaveType type, double height) {
  WavesDescription waves;
  waves.type = type;
  waves.height = height;
  waves.period = 9.0;
  waves.from = 0.7;
  return waves;
}

TEST(stokes_wave, a_low_stokes_wave_is_an_airy_wave) {
  const double height = 1e-5;
  const Sea stokes = make_sea(description(WaveType::stokes5, height), 40.0, 1);
  const Sea airy = make_sea(description(WaveType::airy, height), 40.0, 1);
  for (const Vec3& point : {Vec3(0, 0, -1), Vec3(20, -30, -12), Vec3(70, 10, -38)}) {
    WaterState a, b;
    water_state(stokes, 2.2, {}, {&point, 1}, {&a, 1});
    water_state(airy, 2.2, {}, {&point, 1}, {&b, 1});
    EXPECT_NEAR(a.elevation, b.elevation, 1e-5 * height);  // of the order of the steepness, 3e-7
    EXPECT_LT((a.velocity - b.velocity).norm(), 1e-5 * height);
    EXPECT_LT((a.acceleration - b.acceleration).norm(), 1e-5 * height);
  }
}

TEST(stokes_wave, the_sea_of_a_stokes_wave_stops_at_surface_and_bed_and_builds_up) {
  const Sea sea = make_sea(description(WaveType::stokes5, 8.0), 40.0, 1);
  const BuildUp b{0.5, 0.02, 0.0};
  const double eta = elevation(sea, 0.0, {}, 0.0, 0.0);
  const std::array<Vec3, 4> points = {Vec3(0, 0, 0.5 * eta), Vec3(0, 0, 20.0), Vec3(0, 0, -40.0), Vec3(0, 0, -99.0)};
  std::array<WaterState, 4> out;
  water_state(sea, 0.0, b, points, out);
  EXPECT_NEAR(out[0].elevation, 0.5 * eta, 1e-15);
  EXPECT_EQ(out[1].velocity, out[0].velocity);
  EXPECT_EQ(out[3].velocity, out[2].velocity);
  const WaveKinematics k = kinematics(sea.stokes, 0.0, 0.0, 0.0, 0.5 * eta);
  EXPECT_LT((out[0].velocity - 0.5 * k.velocity).norm(), 1e-15);
  EXPECT_LT((out[0].acceleration - 0.5 * k.acceleration - 0.02 * k.velocity).norm(), 1e-15);
  EXPECT_EQ(sea.components.size(), 1U);
  EXPECT_EQ(highest_frequency(sea), 5.0 * sea.stokes.omega);
}

TEST(stokes_wave, very_deep_water_does_not_overflow) {
  const StokesWave wave = stokes_wave(10.0, 8.0, 12000.0, 1.0, 0.0, 0.0);
  for (const double z : {4.0, -100.0, -12000.0}) {
    EXPECT_TRUE(kinematics(wave, 1.0, 3.0, 0.0, z).acceleration.allFinite());
  }
}

}  // namespace
}  // namespace overbend
