#include "mechanics/sea.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/constants.h"
#include "model/pipe/section.h"
#include "model/waves/wave_theory.h"

namespace overbend {
namespace {

WavesDescription airy(double height, double period, double from = 0.0) {
  WavesDescription waves;
  waves.type = WaveType::airy;
  waves.height = height;
  waves.period = period;
  waves.from = from;
  return waves;
}

WavesDescription jonswap(double hs, double tp) {
  WavesDescription waves;
  waves.type = WaveType::jonswap;
  waves.hs = hs;
  waves.tp = tp;
  return waves;
}

WaterState state(const Sea& sea, double t, const Vec3& point, const BuildUp& build_up = {}) {
  WaterState out;
  water_state(sea, t, build_up, {&point, 1}, {&out, 1});
  return out;
}

TEST(sea, calm_water_does_not_move) {
  const Sea sea = make_sea(WavesDescription{}, 100.0, 1);
  EXPECT_TRUE(sea.calm());
  EXPECT_EQ(state(sea, 3.0, Vec3(1, 2, -3)).velocity, Vec3::Zero());
  EXPECT_EQ(elevation(sea, 3.0, {}, 1.0, 2.0), 0.0);
  EXPECT_EQ(highest_frequency(sea), 0.0);
}

TEST(sea, waves_travel_away_from_where_they_come) {
  const Sea sea = make_sea(airy(2.0, 8.0, 270.0 * kDegree), 100.0, 1);  // from the west
  const WaveComponent& wave = sea.components.at(0);
  EXPECT_NEAR(wave.kx, wave.wave_number, 1e-15);
  EXPECT_NEAR(wave.ky, 0.0, 1e-15);
  const double length = 2.0 * kPi / wave.wave_number;
  EXPECT_NEAR(elevation(sea, 0.0, {}, 0.0, 0.0), 1.0, 1e-14);
  EXPECT_NEAR(elevation(sea, 2.0, {}, 0.25 * length, 30.0), 1.0, 1e-13);  // a quarter period, a quarter length east
}

TEST(sea, a_crest_passes_the_origin_when_the_phase_says) {
  WavesDescription waves = airy(2.0, 8.0);
  waves.phase = 90.0 * kDegree;
  EXPECT_NEAR(elevation(make_sea(waves, 100.0, 1), 2.0, {}, 0.0, 0.0), 1.0, 1e-14);
}

// Amplitude 1e-7 m, so that stretching, of the order k a = 1e-8, does not show.
class LinearWave : public ::testing::TestWithParam<double> {
 protected:
  const double kAmplitude = 1e-7, kPeriod = 7.0;
  const double depth = GetParam();
  const Sea sea = make_sea(airy(2.0 * kAmplitude, kPeriod, 200.0 * kDegree), depth, 1);
  const WaveComponent wave = sea.components.at(0);
  const Vec3 ahead = Vec3(wave.kx, wave.ky, 0.0) / wave.wave_number;
};

TEST_P(LinearWave, has_the_closed_forms_of_surface_and_bed) {
  const double k = wave.wave_number, omega = 2.0 * kPi / kPeriod, scale = kAmplitude * omega;
  const WaterState crest = state(sea, 0.0, Vec3(0, 0, 0));
  EXPECT_NEAR(crest.elevation, kAmplitude, 1e-12 * kAmplitude);
  EXPECT_NEAR(crest.velocity.dot(ahead), scale / std::tanh(k * depth), 1e-6 * scale);
  EXPECT_NEAR(crest.acceleration.z(), -omega * scale, 1e-6 * omega * scale);
  const WaterState bed = state(sea, 0.0, Vec3(0, 0, -depth));
  const double at_bed = k * depth < kWaveReach ? scale / std::sinh(k * depth) : 0.0;
  EXPECT_NEAR(bed.velocity.dot(ahead), at_bed, 1e-6 * scale);
  EXPECT_NEAR(state(sea, 0.3 * kPeriod, Vec3(0, 0, -depth)).velocity.z(), 0.0, 1e-15 * scale);
}

TEST_P(LinearWave, has_the_pressure_that_moves_it) {
  // Linear Bernoulli at still water level: g eta = -dphi/dt, whose derivative along the wave is the acceleration.
  const Vec3 point(3.0, 5.0, 0.0);
  for (const double t : {0.4, 1.9, 3.3, 6.1}) {
    const double h = 0.01;
    const Vec3 before = point - h * ahead, after = point + h * ahead;
    const double slope =
        (elevation(sea, t, {}, after.x(), after.y()) - elevation(sea, t, {}, before.x(), before.y())) / (2.0 * h);
    EXPECT_NEAR(state(sea, t, point).acceleration.dot(ahead), -kGravity * slope, 1e-5 * kGravity * kAmplitude);
  }
}

TEST_P(LinearWave, accelerates_as_its_velocity_changes) {
  const double omega = 2.0 * kPi / kPeriod, h = 1e-3;
  for (const double z : {0.0, -0.2 * depth, -0.7 * depth}) {
    const Vec3 point(3.0, -4.0, std::min(z, -2e-7));
    const Vec3 difference = (state(sea, 1.1 + h, point).velocity - state(sea, 1.1 - h, point).velocity) / (2.0 * h);
    // Central differences are off by (omega h)^2/6 = 1e-7.
    EXPECT_LT((state(sea, 1.1, point).acceleration - difference).norm(), 1e-6 * kAmplitude * omega * omega);
  }
}

TEST_P(LinearWave, keeps_the_volume_of_the_water) {
  const double h = 1e-3;
  for (const double z : {-0.05 * depth, -0.3 * depth}) {
    const Vec3 point(10.0, 20.0, z);
    double divergence = 0.0, max_value = 0.0;
    for (int i = 0; i < 3; ++i) {
      const Vec3 step = h * Vec3::Unit(i);
      const double term =
          (state(sea, 0.9, point + step).velocity[i] - state(sea, 0.9, point - step).velocity[i]) / (2 * h);
      divergence += term;
      max_value = std::max(max_value, std::abs(term));
    }
    EXPECT_GT(max_value, 0.0);
    EXPECT_NEAR(divergence, 0.0, 1e-6 * kAmplitude * wave.omega * wave.wave_number);
  }
}

TEST_P(LinearWave, moves_the_water_in_ellipses_that_close) {
  // Displacement amplitudes a cosh/sinh and a sinh/sinh: (u/A)^2 + (w/B)^2 = omega^2 at every time.
  const double k = wave.wave_number, z = -0.1 * depth;
  const double A = kAmplitude * std::cosh(k * (z + depth)) / std::sinh(k * depth);
  const double B = kAmplitude * std::sinh(k * (z + depth)) / std::sinh(k * depth);
  for (const double t : {0.0, 0.7, 2.9, 5.0}) {
    const Vec3 v = state(sea, t, Vec3(1, 1, z)).velocity;
    EXPECT_NEAR(std::pow(v.dot(ahead) / A, 2) + std::pow(v.z() / B, 2), wave.omega * wave.omega, 1e-6);
  }
}

INSTANTIATE_TEST_SUITE_P(depths, LinearWave, ::testing::Values(4.0, 15.0, 60.0, 300.0));

TEST(sea, the_surface_carries_the_motion_of_still_water_level) {
  const Sea sea = make_sea(airy(6.0, 10.0, 180.0 * kDegree), 40.0, 1);
  const WaveComponent& wave = sea.components[0];
  const double k = wave.wave_number, d = 40.0, eta = 3.0;
  const double at_level = eta * wave.omega / std::tanh(k * d);
  EXPECT_NEAR(state(sea, 0.0, Vec3(0, 0, eta)).velocity.y(), at_level, 1e-12 * at_level);
  EXPECT_NEAR(state(sea, 0.0, Vec3(0, 0, eta + 5.0)).velocity.y(), at_level, 1e-12 * at_level);
  EXPECT_NEAR(state(sea, 0.5 * 10.0, Vec3(0, 0, -eta)).velocity.y(), -at_level, 1e-9 * at_level);  // trough
  // Halfway between: z' = (z - eta) d/(d + eta).
  const double z = (0.5 - eta) * d / (d + eta);
  EXPECT_NEAR(state(sea, 0.0, Vec3(0, 0, 0.5)).velocity.y(),
              eta * wave.omega * std::cosh(k * (z + d)) / std::sinh(k * d), 1e-12 * at_level);
  EXPECT_EQ(state(sea, 0.0, Vec3(0, 0, -60.0)).velocity, state(sea, 0.0, Vec3(0, 0, -d)).velocity);
}

TEST(sea, build_up_scales_the_motion_and_adds_its_own_acceleration) {
  // A wave this low is not touched by stretching, which the build-up would change too.
  const Sea sea = make_sea(airy(2e-7, 9.0), 50.0, 1);
  const Vec3 point(1.0, 2.0, -3.0);
  for (const double t : {-50.0, -31.0, -4.0}) {
    const BuildUp b = half_cosine(t, 60.0);
    const WaterState plain = state(sea, t, point), built = state(sea, t, point, b);
    EXPECT_NEAR(built.elevation, b.value * plain.elevation, 1e-20);
    EXPECT_DOUBLE_EQ(elevation(sea, t, b, 1.0, 2.0), built.elevation);
    const double h = 1e-3;
    const Vec3 difference = (state(sea, t + h, point, half_cosine(t + h, 60.0)).velocity -
                             state(sea, t - h, point, half_cosine(t - h, 60.0)).velocity) /
                            (2.0 * h);
    EXPECT_LT((built.acceleration - difference).norm(), 1e-6 * 1e-7 * sea.components[0].omega);
    EXPECT_LT((built.velocity - b.value * plain.velocity).norm(), 1e-13);
  }
}

TEST(sea, many_points_are_treated_like_each_alone) {
  const Sea sea = make_sea(jonswap(3.0, 9.0), 80.0, 4);
  std::vector<Vec3> points;
  for (int i = 0; i < 17; ++i) points.emplace_back(7.0 * i, -3.0 * i, 2.0 - 5.0 * i);
  std::vector<WaterState> out(points.size());
  const BuildUp half{0.5, 0.01, 0.0};
  water_state(sea, 12.0, half, points, out);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const WaterState alone = state(sea, 12.0, points[i], half);
    EXPECT_EQ(out[i].velocity, alone.velocity);
    EXPECT_EQ(out[i].acceleration, alone.acceleration);
    EXPECT_NEAR(out[i].elevation, elevation(sea, 12.0, half, points[i].x(), points[i].y()), 1e-13);
  }
}

/// The sums written out with the library's functions and nothing left out.
WaterState plain_sum(const Sea& sea, double t, const Vec3& point) {
  WaterState out;
  for (const WaveComponent& c : sea.components) {
    out.elevation += c.amplitude * std::cos(c.kx * point.x() + c.ky * point.y() - c.omega * t + c.phase);
  }
  const double d = sea.depth;
  const double z = std::clamp((point.z() - out.elevation) * d / (d + out.elevation), -d, 0.0);
  for (const WaveComponent& c : sea.components) {
    const double phase = c.kx * point.x() + c.ky * point.y() - c.omega * t + c.phase, k = c.wave_number;
    const double down = std::exp(k * z), up = std::exp(-k * (z + 2.0 * d)), scale = 1.0 - std::exp(-2.0 * k * d);
    const double across = c.amplitude * c.omega * (down + up) / scale;
    const double rise = c.amplitude * c.omega * (down - up) / scale;
    const Vec3 ahead(c.kx / k, c.ky / k, 0.0);
    out.velocity += across * std::cos(phase) * ahead + rise * std::sin(phase) * Vec3::UnitZ();
    out.pressure_head += c.omega / (k * kGravity) * across * std::cos(phase);
    out.acceleration += c.omega * (across * std::sin(phase) * ahead - rise * std::cos(phase) * Vec3::UnitZ());
  }
  return out;
}

TEST(sea, the_fast_sum_is_the_plain_sum_where_all_components_reach) {
  for (const int components : {1, 7, 200, 1500}) {  // beyond 1024 phases are found twice
    WavesDescription waves = jonswap(4.0, 10.0);
    waves.components = components;
    waves.spreading = 4.0;
    const Sea sea = make_sea(waves, 90.0, 9);
    for (const double t : {0.0, 123.4, 10800.0}) {
      const Vec3 point(-250.0, 80.0, -0.5);
      const WaterState fast = state(sea, t, point), plain = plain_sum(sea, t, point);
      EXPECT_NEAR(fast.elevation, plain.elevation, 1e-10);
      EXPECT_LT((fast.velocity - plain.velocity).norm(), 1e-10);
      EXPECT_LT((fast.acceleration - plain.acceleration).norm(), 1e-10);
      EXPECT_NEAR(fast.pressure_head, plain.pressure_head, 1e-10);
    }
  }
}

TEST(sea, its_pressure_is_the_weight_of_the_surface_there_and_what_accelerates_the_water_below) {
  WavesDescription waves = jonswap(0.02, 8.0);  // so low that stretching moves nothing
  waves.spreading = 4.0;
  const Sea sea = make_sea(waves, 60.0, 4);
  const double t = 33.0, h = 0.01;
  const Vec3 surface(12.0, -7.0, elevation(sea, t, {}, 12.0, -7.0));
  EXPECT_NEAR(state(sea, t, surface).pressure_head, surface.z(), 1e-12);
  const Vec3 point(12.0, -7.0, -9.0);
  const auto slope = [&](const Vec3& d) {
    return (state(sea, t, point + h * d).pressure_head - state(sea, t, point - h * d).pressure_head) / (2.0 * h);
  };
  const Vec3 pushed = -kGravity * Vec3(slope(Vec3::UnitX()), slope(Vec3::UnitY()), slope(Vec3::UnitZ()));
  // Stretching and the finite difference leave a thousandth.
  EXPECT_LT((state(sea, t, point).acceleration - pushed).norm(), 1e-3 * pushed.norm());
}

TEST(sea, what_is_left_out_at_depth_is_less_than_a_thousandth_of_the_surface_motion) {
  const Sea sea = make_sea(jonswap(4.0, 10.0), 900.0, 2);
  double speed = 0.0, change = 0.0;  // standard deviations at the surface
  for (const WaveComponent& c : sea.components) {
    speed += 0.5 * std::pow(c.amplitude * c.omega, 2);
    change += 0.5 * std::pow(c.amplitude * c.omega * c.omega, 2);
  }
  double worst = 0.0;
  for (double z = 0.0; z > -900.0; z -= 3.7) {
    const WaterState fast = state(sea, 77.0, Vec3(5, 6, z)), plain = plain_sum(sea, 77.0, Vec3(5, 6, z));
    worst = std::max(worst, (fast.velocity - plain.velocity).norm() / std::sqrt(speed));
    worst = std::max(worst, (fast.acceleration - plain.acceleration).norm() / std::sqrt(change));
  }
  EXPECT_LT(worst, 1e-3);
  EXPECT_GT(worst, 1e-9);  // something is left out
}

TEST(sea, deep_water_does_not_overflow) {
  const Sea sea = make_sea(jonswap(2.0, 4.0), 12000.0, 2);
  for (const double z : {3.0, 0.0, -1.0, -100.0, -6000.0, -12000.0}) {
    EXPECT_TRUE(state(sea, 55.0, Vec3(1, 2, z)).velocity.allFinite());
    EXPECT_TRUE(state(sea, 55.0, Vec3(1, 2, z)).acceleration.allFinite());
  }
}

TEST(sea, given_waves_are_sorted_and_get_their_wave_numbers) {
  const Sea sea =
      make_sea({{.amplitude = 1.0, .omega = 1.2, .kx = 1.0}, {.amplitude = 0.5, .omega = 0.6, .ky = -1.0}}, 70.0);
  ASSERT_EQ(sea.components.size(), 2U);
  EXPECT_EQ(sea.components[0].omega, 0.6);
  EXPECT_NEAR(sea.components[0].ky, -linear_wave_number(0.6, 70.0), 1e-15);
  EXPECT_NEAR(sea.components[1].kx, linear_wave_number(1.2, 70.0), 1e-15);
  EXPECT_EQ(highest_frequency(sea), 1.2);
}

TEST(sea, a_wave_without_size_is_rejected) {
  WavesDescription user;
  user.type = WaveType::user;
  EXPECT_THROW(make_sea(user, 50.0, 1), std::invalid_argument);
  EXPECT_THROW(make_sea(airy(0.0, 5.0), 50.0, 1), std::invalid_argument);
  EXPECT_THROW(make_sea(jonswap(2.0, 0.0), 50.0, 1), std::invalid_argument);
  EXPECT_THROW(make_sea(airy(1.0, 5.0), 0.0, 1), std::invalid_argument);
}

}  // namespace
}  // namespace overbend
