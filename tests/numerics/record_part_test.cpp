#include "numerics/record_part.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "numerics/low_pass.h"

namespace overbend {
namespace {

constexpr double kStep = 1.0, kHours = 10800.0;

/// Narrow-banded Gaussian noise of unit variance about a period [s]: an oscillator of damping ratio `damping` driven by
/// white noise, sampled exactly.
std::vector<double> band(double period, double damping, std::size_t count, unsigned seed) {
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal(0.0, 1.0);
  const double w = 2.0 * std::numbers::pi / period, decay = std::exp(-damping * w * kStep);
  const double turn = w * std::sqrt(1.0 - damping * damping) * kStep, kick = std::sqrt(1.0 - decay * decay);
  double x = normal(generator), y = normal(generator);
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) {
    values.push_back(x);
    const double turned = decay * (std::cos(turn) * x - std::sin(turn) * y);
    y = decay * (std::sin(turn) * x + std::cos(turn) * y) + kick * normal(generator);
    x = turned + kick * normal(generator);
  }
  return values;
}

TEST(record_part, heights_of_a_sine_are_its_amplitude) {
  std::vector<double> values;
  for (int i = 0; i < 4000; ++i) values.push_back(3.0 + 2.0 * std::sin(2.0 * std::numbers::pi * i / 20.0));
  const PartHeights heights = compute_heights(values, kStep, kHours);
  EXPECT_NEAR(heights.significant, 2.0, 1e-9);
  EXPECT_NEAR(heights.maximum, 2.0, 1e-9);
  EXPECT_NEAR(heights.cycles, 199.0, 1.0);
}

TEST(record_part, few_slow_cycles_reach_what_a_gaussian_process_does) {
  std::vector<double> values;
  for (int i = 0; i < 1000; ++i) values.push_back(std::sin(2.0 * std::numbers::pi * i / 80.0));
  const PartHeights heights = compute_heights(values, kStep, kHours);
  EXPECT_NEAR(heights.maximum, std::sqrt(0.5) * std::sqrt(2.0 * std::log(kHours / 80.0)), 0.05);
}

// The mean of the largest values of 50 realisations of three hours is Gumbel's mean, a little above their mode.
TEST(record_part, combined_height_is_the_most_probable_largest_of_a_gaussian_sum) {
  const auto count = static_cast<std::size_t>(kHours / kStep);
  std::vector<double> maximum;
  double estimates = 0.0;
  constexpr unsigned kRuns = 50;
  for (unsigned seed = 0; seed < kRuns; ++seed) {
    const std::vector<double> slow = low_pass(band(80.0, 0.1, count, seed), kStep, 30.0);
    const std::vector<double> wave = low_pass(band(10.0, 0.15, count, 1000 + seed), kStep, 5.0);
    double max_value = 0.0;
    for (std::size_t i = 0; i < count; ++i) max_value = std::max(max_value, 1.5 * slow[i] + wave[i]);
    maximum.push_back(max_value);
    std::vector<double> scaled = slow;
    for (double& value : scaled) value *= 1.5;
    estimates += combined_height(compute_heights(scaled, kStep, kHours), compute_heights(wave, kStep, kHours)) / kRuns;
  }
  std::nth_element(maximum.begin(), maximum.begin() + kRuns * 37 / 100, maximum.end());
  const double mode = maximum[kRuns * 37 / 100];  // a Gumbel variable is below its mode with probability 1/e
  EXPECT_NEAR(estimates, mode, 0.06 * mode);
}

TEST(record_part, a_part_that_is_not_there_adds_nothing) {
  const PartHeights wave = compute_heights(band(10.0, 0.2, 20000, 7), kStep, kHours);
  const PartHeights none = compute_heights(std::vector<double>(20000, 4.0), kStep, kHours);
  EXPECT_DOUBLE_EQ(combined_height(none, wave), wave.maximum);
}

TEST(record_part, deviation_error_is_the_scatter_over_realisations) {
  std::vector<double> deviations;
  double predicted = 0.0, mean = 0.0;
  constexpr unsigned kRuns = 80;
  for (unsigned seed = 0; seed < kRuns; ++seed) {
    const std::vector<double> values = band(80.0, 0.1, 3600, 300 + seed);
    double squares = 0.0;
    for (const double value : values) squares += value * value;
    deviations.push_back(std::sqrt(squares / 3600.0));
    mean += deviations.back() / kRuns;
    predicted += deviation_error(values, kStep, 5.0) / kRuns;
  }
  double scatter = 0.0;
  for (const double deviation : deviations) scatter += (deviation - mean) * (deviation - mean) / kRuns;
  // An hour of oscillations of damping ratio 0.1: 1/(2 sqrt(zeta omega T)).
  const double theory = 0.5 / std::sqrt(0.1 * 2.0 * std::numbers::pi / 80.0 * 3600.0);
  EXPECT_NEAR(std::sqrt(scatter) / mean, theory, 0.25 * theory);
  EXPECT_NEAR(predicted, theory, 0.15 * theory);
}

}  // namespace
}  // namespace overbend
