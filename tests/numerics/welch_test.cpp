#include "numerics/welch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace overbend {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;

double integral(const PowerSpectrum& spectrum) {
  double sum = 0.0;
  for (const double density : spectrum.density) {
    sum += density;
  }
  return sum * spectrum.frequency[1];
}

std::vector<double> noise(std::size_t count, unsigned seed) {
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal(5.0, 2.0);
  std::vector<double> values(count);
  std::generate(values.begin(), values.end(), [&] { return normal(generator); });
  return values;
}

TEST(power_spectrum, of_one_segment_obeys_parseval_to_rounding) {
  // Power of the windowed values over the power of the window, both summed here.
  for (const std::size_t count : {64u, 300u, 511u, 512u}) {
    const std::vector<double> values = noise(count, 3);
    double mean = 0.0;
    for (const double value : values) {
      mean += value / static_cast<double>(count);
    }
    double windowed = 0.0, window = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      const double w = std::pow(std::sin(0.5 * kTwoPi * static_cast<double>(i) / static_cast<double>(count)), 2);
      windowed += std::pow(w * (values[i] - mean), 2);
      window += w * w;
    }
    const PowerSpectrum spectrum = power_spectrum(values, 0.5);
    EXPECT_EQ(spectrum.segments, 1);
    EXPECT_NEAR(integral(spectrum), windowed / window, 1e-12 * windowed / window);
  }
}

TEST(power_spectrum, integral_is_the_variance) {
  const std::vector<double> values = noise(20000, 4);
  double mean = 0.0, variance = 0.0;
  for (const double value : values) {
    mean += value / 20000.0;
  }
  for (const double value : values) {
    variance += (value - mean) * (value - mean) / 20000.0;
  }
  // Only the ends of the record are weighted less: 2,000 of 20,000 values by half, whose own variance scatters by 3 %.
  EXPECT_NEAR(integral(power_spectrum(values, 0.25)), variance, 0.005 * variance);
}

TEST(power_spectrum, of_white_noise_is_flat) {
  const PowerSpectrum spectrum = power_spectrum(noise(200000, 5), 0.5);
  const double level = 2.0 * 0.5 * 4.0;  // one-sided: 2 dt sigma^2
  double low = 0.0, high = 0.0;
  for (std::size_t k = 1; k <= 512; ++k) {
    (k <= 256 ? low : high) += spectrum.density[k] / 256.0;
  }
  EXPECT_NEAR(low, level, 0.02 * level);  // half the power each, from 100,000 values: 0.4 % scatter
  EXPECT_NEAR(high, level, 0.02 * level);
}

TEST(power_spectrum, a_sine_peaks_at_its_frequency_with_its_power) {
  const double step = 0.5, frequency = 0.1, amplitude = 3.0;
  std::vector<double> values(10800);
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = 7.0 + amplitude * std::sin(kTwoPi * frequency * step * static_cast<double>(i) + 0.3);
  }
  const PowerSpectrum spectrum = power_spectrum(values, step);
  const auto peak = std::max_element(spectrum.density.begin(), spectrum.density.end()) - spectrum.density.begin();
  EXPECT_NEAR(spectrum.frequency[static_cast<std::size_t>(peak)], frequency, 0.5 * spectrum.frequency[1] + 1e-12);
  EXPECT_NEAR(integral(spectrum), 0.5 * amplitude * amplitude, 1e-3);  // the record ends off a whole period
  double around = 0.0;
  for (auto k = peak - 4; k <= peak + 4; ++k) {  // the window's lobe is four points wide, what is beyond is below 1 %
    around += spectrum.density[static_cast<std::size_t>(k)] * spectrum.frequency[1];
  }
  EXPECT_GT(around, 0.99 * integral(spectrum));
}

TEST(power_spectrum, number_of_frequencies_follows_the_record) {
  struct Case {
    std::size_t values, frequencies;
    int segments;
  };
  for (const Case& c : {Case{100, 257, 1}, Case{600, 257, 1}, Case{4095, 257, 14}, Case{4096, 513, 7},
                        Case{8192, 1025, 7}, Case{100000, 1025, 96}}) {
    const PowerSpectrum spectrum = power_spectrum(noise(c.values, 6), 0.5);
    EXPECT_EQ(spectrum.frequency.size(), c.frequencies) << c.values;
    EXPECT_EQ(spectrum.density.size(), c.frequencies);
    EXPECT_EQ(spectrum.segments, c.segments) << c.values;
    EXPECT_DOUBLE_EQ(spectrum.frequency.back(), 1.0);  // half the sampling rate
  }
}

TEST(power_spectrum, of_next_to_nothing_is_empty_and_of_a_constant_zero) {
  EXPECT_TRUE(power_spectrum(std::vector<double>(7, 1.0), 0.5).frequency.empty());
  for (const double density : power_spectrum(std::vector<double>(3000, 4.0), 0.5).density) {
    EXPECT_EQ(density, 0.0);
  }
}

}  // namespace
}  // namespace overbend
