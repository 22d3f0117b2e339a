#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "base/constants.h"
#include "mechanics/sea.h"
#include "mechanics/wave_spreading.h"

namespace overbend {
namespace {

constexpr double kHours = 3600.0;

WavesDescription jonswap() {
  WavesDescription waves;
  waves.type = WaveType::jonswap;
  waves.hs = 4.0;
  waves.tp = 10.0;
  waves.gamma = 3.3;
  return waves;
}

/// Sum of a^2/2 omega^n over the components.
double moment(const Sea& sea, int n) {
  double sum = 0.0;
  for (const WaveComponent& c : sea.components) sum += 0.5 * c.amplitude * c.amplitude * std::pow(c.omega, n);
  return sum;
}

TEST(random_sea, the_components_hold_the_variance_exactly) {
  for (const int count : {1, 13, 200, 5000}) {
    WavesDescription waves = jonswap();
    waves.components = count;
    for (const std::optional<double> spreading : {std::optional<double>{}, std::optional<double>{3.0}}) {
      waves.spreading = spreading;
      const Sea sea = make_sea(waves, 89.0, 5);
      EXPECT_EQ(sea.components.size(), static_cast<std::size_t>(count));
      EXPECT_NEAR(moment(sea, 0), 1.0, 1e-12);
    }
  }
}

TEST(random_sea, without_the_highest_frequencies_the_mean_zero_crossing_period_is_two_per_cent_longer) {
  // Tz/Tp of the whole JONSWAP spectrum by DNV-RP-C205, 3.5.5.4, for gamma 3.3.
  constexpr double kGamma = 3.3;
  const double whole = 0.6673 + kGamma * (0.05037 + kGamma * (-0.006230 + kGamma * 0.0003341));
  double mean = 0.0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Sea sea = make_sea(jonswap(), 89.0, seed);
    const double period = 2.0 * kPi * std::sqrt(moment(sea, 0) / moment(sea, 2));
    EXPECT_NEAR(period / (10.0 * whole), 1.02, 0.018);
    mean += period / (10.0 * whole) / 20.0;
  }
  EXPECT_NEAR(mean, 1.02, 0.005);
}

TEST(random_sea, components_rise_and_obey_the_dispersion_relation) {
  const Sea sea = make_sea(jonswap(), 30.0, 5);
  EXPECT_TRUE(std::is_sorted(sea.components.begin(), sea.components.end(),
                             [](const auto& a, const auto& b) { return a.wave_number < b.wave_number; }));
  for (const WaveComponent& c : sea.components) {
    EXPECT_NEAR(9.80665 * c.wave_number * std::tanh(c.wave_number * 30.0) / (c.omega * c.omega), 1.0, 4e-15);
    EXPECT_NEAR(std::hypot(c.kx, c.ky), c.wave_number, 1e-15);
  }
  EXPECT_EQ(highest_frequency(sea), sea.components.back().omega);
}

TEST(random_sea, moments_and_mean_period_are_those_of_the_spectrum) {
  const WaveSpectrum spectrum(jonswap());
  const double peak = 2.0 * kPi / 10.0;
  double m1 = 0.0, m2 = 0.0, m0 = 0.0;
  for (double omega = 0.4 * peak; omega < 5.0 * peak; omega += 1e-5) {
    m0 += 1e-5 * spectrum.density(omega);
    m1 += 1e-5 * omega * spectrum.density(omega);
    m2 += 1e-5 * omega * omega * spectrum.density(omega);
  }
  // One frequency is drawn from each of 200 slices. The last, from 3.4 to 5 peak frequencies, has the largest
  // say: half its width over 200 is 0.3 % of the mean frequency and 1.9 % of the mean square.
  const double expected = 2.0 * kPi * std::sqrt(m0 / m2);
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const Sea sea = make_sea(jonswap(), 89.0, seed);
    EXPECT_NEAR(moment(sea, 1) / (m1 / m0), 1.0, 0.005);
    EXPECT_NEAR(moment(sea, 2) / (m2 / m0), 1.0, 0.02);
    EXPECT_NEAR(2.0 * kPi / std::sqrt(moment(sea, 2) / moment(sea, 0)), expected, 0.01 * expected);
  }
}

TEST(random_sea, frequencies_crowd_at_the_peak) {
  WavesDescription waves = jonswap();
  waves.components = 2000;
  const Sea sea = make_sea(waves, 89.0, 1);
  const double peak = 2.0 * kPi / 10.0;
  std::vector<int> seen(100, 0);  // in classes of 5 % of the peak frequency
  for (const WaveComponent& c : sea.components) ++seen.at(static_cast<std::size_t>(c.omega / peak / 0.05));
  const auto max_value = std::max_element(seen.begin(), seen.end()) - seen.begin();
  EXPECT_NEAR(0.05 * (static_cast<double>(max_value) + 0.5), 1.0, 0.03);
}

struct Record {
  double mean = 0.0, variance = 0.0, zero_crossing_period = 0.0;
};

Record make_record(const Sea& sea, double duration, double step) {
  Record record;
  const int count = static_cast<int>(duration / step);
  double before = 0.0;
  int crossings = 0;
  for (int i = 0; i < count; ++i) {
    const double eta = elevation(sea, step * i, {}, 0.0, 0.0);
    record.mean += eta / count;
    record.variance += eta * eta / count;
    crossings += i > 0 && before <= 0.0 && eta > 0.0 ? 1 : 0;
    before = eta;
  }
  record.variance -= record.mean * record.mean;
  record.zero_crossing_period = duration / crossings;
  return record;
}

TEST(random_sea, records_have_the_statistics_of_the_spectrum) {
  constexpr int kRecords = 8;
  constexpr double kDuration = 3.0 * kHours;
  const WaveSpectrum spectrum(jonswap());
  double squares = 0.0;
  for (double omega = 0.2; omega < 4.0; omega += 1e-4) squares += 1e-4 * std::pow(spectrum.density(omega), 2);
  Record mean;
  for (std::uint64_t seed = 1; seed <= kRecords; ++seed) {
    const Sea sea = make_sea(jonswap(), 89.0, seed);
    const Record record = make_record(sea, kDuration, 0.5);
    mean.mean += record.mean / kRecords;
    mean.variance += record.variance / kRecords;
    mean.zero_crossing_period +=
        record.zero_crossing_period / (2.0 * kPi * std::sqrt(moment(sea, 0) / moment(sea, 2))) / kRecords;
  }
  // The variance of a Gaussian record of length T scatters by sqrt(2 pi int S^2/T), here 5 % of m0 = 1.
  const double scatter = std::sqrt(2.0 * kPi * squares / (kDuration * kRecords));
  EXPECT_LT(scatter, 0.03);
  EXPECT_NEAR(mean.variance, 1.0, 3.0 * scatter);
  EXPECT_NEAR(mean.mean, 0.0, 1e-3);  // no energy at low frequency: 1/(omega T)
  // 1400 crossings a record; their number scatters by some 2 % of it.
  EXPECT_NEAR(mean.zero_crossing_period, 1.0, 0.02);
}

TEST(random_sea, the_record_does_not_repeat_itself) {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
    // 200 phasors of random phase add up to 1/sqrt(200) = 0.07 of their sum, to 0.21 once in 10000 trials.
    const double again = recurrence(make_sea(jonswap(), 89.0, seed), 3.0 * kHours);
    EXPECT_LT(again, 0.3);
    EXPECT_GT(again, 0.07);
  }
  WavesDescription waves = jonswap();
  waves.components = 2;  // a beat
  EXPECT_GT(recurrence(make_sea(waves, 89.0, 1), 3.0 * kHours), 0.95);
}

TEST(random_sea, recurrence_is_the_largest_envelope_of_the_autocorrelation) {
  const Sea sea = make_sea(jonswap(), 89.0, 5);
  double energy = 0.0, moment = 0.0, max_magnitude = 0.0;
  for (const WaveComponent& c : sea.components) {
    energy += c.amplitude * c.amplitude;
    moment += c.amplitude * c.amplitude * c.omega;
  }
  const double period = 2.0 * kPi * energy / moment;
  for (int quarter = 120; 0.25 * period * quarter <= kHours; ++quarter) {
    std::complex<double> sum;
    for (const WaveComponent& c : sea.components) {
      sum += c.amplitude * c.amplitude * std::polar(1.0, c.omega * 0.25 * period * quarter);
    }
    max_magnitude = std::max(max_magnitude, std::abs(sum) / energy);
  }
  EXPECT_NEAR(recurrence(sea, kHours), max_magnitude, 1e-12);  // rounding of 512 turns
  EXPECT_EQ(recurrence(sea, 20.0 * period), 0.0);              // shorter than the lags that are looked at
}

TEST(random_sea, the_same_seed_is_the_same_sea) {
  WavesDescription waves = jonswap();
  waves.spreading = 5.0;
  const Sea a = make_sea(waves, 89.0, 77), b = make_sea(waves, 89.0, 77);
  const Sea second_sea = make_sea(waves, 89.0, 78);
  for (std::size_t i = 0; i < a.components.size(); ++i) {
    EXPECT_EQ(a.components[i].omega, b.components[i].omega);
    EXPECT_EQ(a.components[i].phase, b.components[i].phase);
    EXPECT_EQ(a.components[i].kx, b.components[i].kx);
    EXPECT_NE(a.components[i].phase, second_sea.components[i].phase);
  }
  // The first phase is the generator's second number, as computed once outside this program for seed 42.
  EXPECT_EQ(make_sea(waves, 89.0, 42).components[0].phase,
            2.0 * kPi * static_cast<double>(5881210131331364753U >> 11U) * 0x1p-53);
}

TEST(random_sea, spreading_changes_directions_alone) {
  WavesDescription waves = jonswap();
  const Sea straight = make_sea(waves, 89.0, 3);
  waves.spreading = 5.0;
  const Sea spread = make_sea(waves, 89.0, 3);
  for (std::size_t i = 0; i < spread.components.size(); ++i) {
    EXPECT_EQ(spread.components[i].omega, straight.components[i].omega);
    EXPECT_EQ(spread.components[i].phase, straight.components[i].phase);
  }
}

TEST(random_sea, directions_spread_around_the_mean_as_the_exponent_says) {
  for (const double s : {0.5, 2.0, 10.0, 100.0, 1000.0}) {
    WavesDescription waves = jonswap();
    waves.from = 0.9;
    waves.spreading = s;
    const Sea sea = make_sea(waves, 89.0, 6);
    std::complex<double> sum, doubled;
    for (const WaveComponent& c : sea.components) {
      const double off = std::atan2(c.kx, c.ky) - (0.9 + kPi);
      sum += std::polar(1.0, off) / 200.0;
      doubled += std::polar(1.0, 2.0 * off) / 200.0;
    }
    // Moments of cos^2s(x/2): s/(s + 1) and s (s - 1)/((s + 1)(s + 2)). Slices of 1/200 hold the mean to the part of
    // a slice over sqrt(200), well below 1 % of the circular standard deviation.
    const double sigma = std::sqrt(2.0 / (s + 1.0));
    EXPECT_NEAR(std::arg(sum), 0.0, 0.01 * sigma) << s;
    EXPECT_NEAR(std::abs(sum), s / (s + 1.0), 0.005 * sigma) << s;
    EXPECT_NEAR(std::real(doubled), s * (s - 1.0) / ((s + 1.0) * (s + 2.0)), 0.01 * sigma) << s;
  }
}

TEST(random_sea, directions_do_not_go_with_frequency) {
  Random random(12);
  const std::vector<double> angles = spread_directions(4.0, 1000, random);
  double correlation = 0.0, square = 0.0;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const double rank = (static_cast<double>(i) + 0.5) / 1000.0 - 0.5;
    correlation += rank * angles[i];
    square += angles[i] * angles[i];
  }
  // A random order scatters by 1/sqrt(1000).
  EXPECT_LT(std::abs(correlation) / std::sqrt(square * 1000.0 / 12.0), 4.0 / std::sqrt(1000.0));
}

TEST(random_sea, a_users_spectrum_makes_a_sea_of_its_variance) {
  WavesDescription waves;
  waves.type = WaveType::user;
  waves.spectrum = {{0.4, 0.0}, {0.8, 2.0}, {1.8, 0.0}};
  const Sea sea = make_sea(waves, 50.0, 1);
  EXPECT_NEAR(moment(sea, 0), 1.4, 1e-12);
  EXPECT_GT(sea.components.front().omega, 0.4);
  EXPECT_LT(sea.components.back().omega, 1.8);
}

}  // namespace
}  // namespace overbend
