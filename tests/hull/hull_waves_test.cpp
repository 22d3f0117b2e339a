#include "hull/hull_waves.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/constants.h"
#include "mechanics/wave_spectrum.h"
#include "support/allocation_count.h"
#include "support/hull_case.h"

namespace overbend {
namespace {

const HydrodynamicData& data() {
  return testing::bgl1_hydrodynamics();
}

std::size_t frequency(const std::vector<double>& omega, double w) {
  std::size_t best = 0;
  for (std::size_t i = 0; i < omega.size(); ++i) {
    if (std::abs(omega[i] - w) < std::abs(omega[best] - w)) best = i;
  }
  return best;
}

TEST(hull_waves, force_of_one_component_is_that_of_the_file_with_the_crest_over_the_hull) {
  // The file's headings stand every 15 deg; the hull heads 40 deg, the waves go to 175: 135 from the bow.
  const double w = data().excitation.omega[frequency(data().excitation.omega, 0.725)];
  const Sea sea = testing::regular_sea(1.5, w, 175.0 * kDegree, 0.4);
  const HullWaves waves = make_hull_waves(data(), sea, WaveDrift::none, 5.182, 40.0 * kDegree);
  const WaveComponent& c = sea.components[0];
  const double x = 31.0, y = -12.0, t = 17.3;
  const CVec6 X = data().force[data().excitation.index(frequency(data().excitation.omega, w), 9)];
  const std::complex<double> crest = std::polar(1.5, w * t - c.kx * x - c.ky * y - 0.4);
  const Vec6 expected = (X * crest).real();
  const Vec6 force = wave_force(waves, t, Vec3(x, y, 40.0 * kDegree + 6.0 * kPi)).first_order;
  EXPECT_LT((force - expected).norm(), 1e-9 * X.norm());
}

TEST(hull_waves, force_of_many_components_is_the_plain_sum) {
  const Sea sea = testing::long_crested(4.0, 12.9, 2.1, 7, 75);
  const HullWaves waves = make_hull_waves(data(), sea, WaveDrift::newman, 5.182, 0.3);
  const Vec3 slow(4.0, 9.0, 0.3);
  const double t = 123.4;
  Vec6 expected = Vec6::Zero();
  for (const WaveComponent& c : sea.components) {
    const HullWaves hull_waves = make_hull_waves(data(), make_sea({c}, 89.0), WaveDrift::newman, 5.182, 0.3);
    expected += wave_force(hull_waves, t, slow).first_order;
  }
  EXPECT_LT((wave_force(waves, t, slow).first_order - expected).norm(), 1e-9 * expected.norm());
}

TEST(hull_waves, drift_of_a_regular_wave_is_constant) {
  for (const double heading : {90.0, 135.0, 180.0, 300.0}) {
    const std::size_t i = frequency(data().drift.omega, 0.825);
    const Sea sea = testing::regular_sea(2.0, data().drift.omega[i], heading * kDegree);
    const HullWaves waves = make_hull_waves(data(), sea, WaveDrift::newman, 5.182, 0.0);
    const Vec6 expected = 4.0 * data().mean_drift[data().drift.index(i, static_cast<std::size_t>(heading / 15.0))];
    for (const double t : {0.0, 1.7, 4.1}) {
      const WaveForce f = wave_force(waves, t, Vec3::Zero());
      EXPECT_LT((f.drift - expected).norm(), 1e-9 * expected.norm()) << heading;
      EXPECT_LT((f.mean_drift - expected).norm(), 1e-9 * expected.norm()) << heading;
    }
  }
}

TEST(hull_waves, drift_follows_the_table_as_the_hull_turns) {
  const std::size_t i = frequency(data().drift.omega, 0.875);
  const Sea sea = testing::regular_sea(1.0, data().drift.omega[i], 100.0 * kDegree);
  const HullWaves waves = make_hull_waves(data(), sea, WaveDrift::newman, 5.182, 0.0);
  for (double psi = 10.0; psi < 400.0; psi += 15.0) {  // headings of 90, 75 ... deg from the bow
    const double from_bow = 100.0 - psi + 360.0;
    const auto j = static_cast<std::size_t>(std::lround(from_bow / 15.0)) % 24;
    const Vec6 expected = data().mean_drift[data().drift.index(i, j)];
    const Vec6 drift = wave_force(waves, 3.0, Vec3(0.0, 0.0, psi * kDegree)).drift;
    EXPECT_LT((drift - expected).norm(), 1e-6 * 1e5) << psi;
  }
}

struct Drift {
  double surge, sway, yaw;
};

/// In a sea of 800 components at equal distances over the file's frequencies.
Drift find_mean_drift(double hs, double tp, double heading) {
  WavesDescription description;
  description.type = WaveType::jonswap;
  description.hs = hs;
  description.tp = tp;
  description.gamma = 1.0;
  const WaveSpectrum spectrum(description);
  std::vector<WaveComponent> components(800);
  const double first = 0.2, spacing = 2.0 / 800.0;
  for (std::size_t i = 0; i < components.size(); ++i) {
    WaveComponent& c = components[i];
    c.omega = first + (static_cast<double>(i) + 0.5) * spacing;
    c.amplitude = std::sqrt(2.0 * spectrum.density(c.omega) * spacing);
    c.kx = std::cos(heading * kDegree);
    c.ky = std::sin(heading * kDegree);
  }
  const Sea sea = make_sea(components, 89.0);
  const Vec6 f = mean_drift(make_hull_waves(data(), sea, WaveDrift::mean, 5.182, 0.0), 0.0);
  return {f(0) / 1e3, f(1) / 1e3, f(5) / 1e3};
}

TEST(hull_waves, mean_drift_in_seas_is_that_of_an_independent_integration) {
  // kN and kN m by an independent program's integral of 2 S D; 0.7 % for its and our rules of integration. Yaw depends
  // on whether the value at 0.5 rad/s, where the file's noise begins, is taken: 1,235 without it, 1,264 with it.
  EXPECT_NEAR(find_mean_drift(4.0, 12.9, 90.0).sway, 217.8, 0.005 * 217.8);
  EXPECT_NEAR(find_mean_drift(4.0, 12.9, 135.0).surge, -30.9, 0.15);
  EXPECT_NEAR(find_mean_drift(4.0, 12.9, 135.0).sway, 76.6, 0.4);
  EXPECT_NEAR(find_mean_drift(4.0, 12.9, 135.0).yaw, 1237.0, 35.0);
  EXPECT_NEAR(find_mean_drift(4.0, 12.9, 180.0).surge, -45.4, 0.32);
  EXPECT_NEAR(find_mean_drift(2.5, 10.0, 90.0).sway, 192.2, 1.0);
  EXPECT_NEAR(find_mean_drift(2.5, 10.0, 180.0).surge, -39.8, 0.2);
  EXPECT_NEAR(find_mean_drift(1.5, 8.0, 90.0).sway, 115.9, 0.6);
  EXPECT_NEAR(find_mean_drift(1.5, 8.0, 180.0).surge, -23.9, 0.12);
}

TEST(hull_waves, slow_drift_has_the_exponential_distributions_standard_deviation) {
  // In a long-crested Gaussian sea a drift of one sign is the square of an envelope: exponentially distributed.
  double sum = 0.0, squares = 0.0, mean = 0.0;
  int count = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Sea sea = testing::long_crested(4.0, 12.9, 0.5 * kPi, seed);
    const HullWaves waves = make_hull_waves(data(), sea, WaveDrift::newman, 5.182, 0.0);
    mean += wave_force(waves, 0.0, Vec3::Zero()).mean_drift(1) / 40.0;
    for (double t = 0.0; t < 6000.0; t += 8.0) {
      const double f = wave_force(waves, t, Vec3::Zero()).drift(1);
      sum += f;
      squares += f * f;
      ++count;
    }
  }
  const double average = sum / count, deviation = std::sqrt(squares / count - average * average);
  // 40 records of 6,000 s: some 10,000 independent values, 1 % of the mean is one standard deviation.
  EXPECT_NEAR(average, 217.8e3, 0.03 * 217.8e3);
  EXPECT_NEAR(mean, 217.8e3, 0.01 * 217.8e3);
  EXPECT_NEAR(deviation, average, 0.03 * average);
}

TEST(hull_waves, spectrum_of_the_slow_drift_is_newmans) {
  // S_F(mu) = 8 int S(w) S(w + mu) D(w + mu/2)^2 dw near the moored sway's 77.1 s: 146,995 kN2 s/rad.
  const double mu = 2.0 * kPi / 77.1, length = 6000.0, dt = 6.0;
  double density = 0.0;
  const int seeds = 30;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const Sea sea = testing::long_crested(4.0, 12.9, 0.5 * kPi, 100 + seed);
    const HullWaves waves = make_hull_waves(data(), sea, WaveDrift::newman, 5.182, 0.0);
    std::vector<double> f;
    for (double t = 0.0; t < length; t += dt) f.push_back(wave_force(waves, t, Vec3::Zero()).drift(1) - 217.8e3);
    // Five neighbouring lines of the periodogram about mu.
    for (int line = -2; line <= 2; ++line) {
      const double w = mu + line * 2.0 * kPi / length;
      std::complex<double> transform = 0.0;
      for (std::size_t i = 0; i < f.size(); ++i) transform += f[i] * std::polar(dt, -w * dt * static_cast<double>(i));
      density += std::norm(transform) / (kPi * length) / (5.0 * seeds);
    }
  }
  // 150 values of an exponential distribution: 8 % is one standard deviation.
  EXPECT_NEAR(density / 1e6, 146995.0, 0.2 * 146995.0);
}

TEST(hull_waves, headings_the_file_lacks_are_rejected) {
  HydrodynamicData half = data();
  const std::size_t all = half.excitation.heading.size(), some = 13;  // 0 to 180 deg
  half.excitation.heading.resize(some);
  half.force.clear();
  for (std::size_t i = 0; i < half.excitation.omega.size(); ++i) {
    for (std::size_t j = 0; j < some; ++j) half.force.push_back(data().force[i * all + j]);
  }
  const Sea sea = testing::regular_sea(1.0, 0.8, 200.0 * kDegree);
  EXPECT_THROW(make_hull_waves(half, sea, WaveDrift::none, 5.0, 0.0), std::invalid_argument);
  EXPECT_NO_THROW(make_hull_waves(half, sea, WaveDrift::none, 5.0, 30.0 * kDegree));
}

TEST(hull_waves, water_at_the_strips_is_the_seas_averaged_over_the_draught) {
  const Sea sea = testing::long_crested(1.0, 9.0, 2.0, 3, 40);
  const HullWaves waves = make_hull_waves(data(), sea, WaveDrift::none, 5.182, 0.7);
  const Vec3 slow(3.0, -5.0, 0.7);
  const StripWater water = strip_water(waves, 41.0, slow, -52.5, 15.0);
  for (int s = 0; s < kHullStrips; ++s) {
    double along = 0.0, across = 0.0;
    const double x = -52.5 + 15.0 * s;
    for (const WaveComponent& c : sea.components) {
      const double place = c.kx * (slow.x() + x * std::cos(0.7)) + c.ky * (slow.y() + x * std::sin(0.7));
      const double k = c.wave_number, d = 89.0, T = 5.182;
      const double mean = (std::sinh(k * d) - std::sinh(k * (d - T))) / (k * T * std::sinh(k * d));
      const double u = c.amplitude * c.omega * mean * std::cos(place - c.omega * 41.0 + c.phase);
      const double travel = std::atan2(c.ky, c.kx) - 0.7;
      along += u * std::cos(travel);
      across += u * std::sin(travel);
    }
    EXPECT_NEAR(water.along[static_cast<std::size_t>(s)], along, 1e-10) << s;
    EXPECT_NEAR(water.across[static_cast<std::size_t>(s)], across, 1e-10) << s;
  }
}

TEST(hull_waves, wave_drift_damping_is_aranhas) {
  // kN s/m by an independent program; the formula is in an integral of S over the file's frequencies.
  const auto damping = [](double hs, double tp, double heading) {
    const Sea sea = testing::long_crested(hs, tp, heading * kDegree, 1, 2000);
    return Mat6(wave_drift_damping(data(), sea, 0.0) / 1e3);
  };
  EXPECT_NEAR(damping(4.0, 12.9, 90.0)(1, 1), 145.0, 3.0);
  EXPECT_NEAR(damping(2.5, 10.0, 90.0)(1, 1), 122.0, 3.0);
  EXPECT_NEAR(damping(1.5, 8.0, 90.0)(1, 1), 67.0, 1.5);
  EXPECT_NEAR(damping(4.0, 12.9, 180.0)(0, 0), 31.0, 1.0);
  EXPECT_NEAR(damping(2.5, 10.0, 180.0)(0, 0), 26.0, 1.0);
  EXPECT_NEAR(damping(1.5, 8.0, 180.0)(0, 0), 15.0, 0.5);
}

TEST(hull_waves, sums_do_not_allocate) {
  const HullWaves waves =
      make_hull_waves(data(), testing::long_crested(2.0, 8.0, 1.0, 1), WaveDrift::newman, 5.182, 0.0);
  wave_force(waves, 0.0, Vec3::Zero());
  const long before = testing::allocation_count();
  const WaveForce f = wave_force(waves, 1.0, Vec3::Zero());
  const StripWater water = strip_water(waves, 1.0, Vec3::Zero(), -50.0, 10.0);
  EXPECT_EQ(testing::allocation_count(), before);
  EXPECT_NE(f.first_order(1) + water.along[0], 0.0);
}

}  // namespace
}  // namespace overbend
