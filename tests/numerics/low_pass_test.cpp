#include "numerics/low_pass.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace overbend {
namespace {

constexpr double kStep = 0.2;

std::vector<double> record(double length, double (*of)(double)) {
  std::vector<double> values;
  for (int i = 0; i <= static_cast<int>(length / kStep); ++i) values.push_back(of(kStep * i));
  return values;
}

double wave(double t, double period) {
  return std::sin(2.0 * std::numbers::pi * t / period + 0.4);
}

TEST(low_pass, straight_lines_pass_unchanged) {
  const auto line = record(600.0, [](double t) { return 3.0 - 0.02 * t; });
  const auto slow = low_pass(line, kStep, 20.0);
  for (std::size_t i = 0; i < line.size(); ++i) EXPECT_NEAR(slow[i], line[i], 2e-4);
}

TEST(low_pass, slow_and_wave_part_of_a_sum_are_distinguished_without_delay) {
  const auto sum = record(1800.0, [](double t) { return 5.0 + 1.5 * wave(t, 77.0) + 2.0 * wave(t, 11.0); });
  const auto slow = low_pass(sum, kStep, 24.0);
  double worst = 0.0;
  for (std::size_t i = 600; i + 600 < sum.size(); ++i) {
    const double t = kStep * static_cast<double>(i);
    worst = std::max(worst, std::abs(slow[i] - 5.0 - 1.5 * wave(t, 77.0)));
  }
  EXPECT_LT(worst, 1e-3);
}

TEST(low_pass, a_sine_keeps_the_share_of_its_amplitude_that_the_formula_says) {
  const auto waves = record(2400.0, [](double t) { return wave(t, 24.0 / 1.28); });
  const auto slow = low_pass(waves, kStep, 24.0);
  const double ratio = std::tan(std::numbers::pi * kStep * 1.28 / 24.0) / std::tan(std::numbers::pi * kStep / 24.0);
  const double share = 1.0 / (1.0 + std::pow(ratio, 12.0));
  double max_value = 0.0;
  for (std::size_t i = 1000; i + 1000 < slow.size(); ++i) max_value = std::max(max_value, std::abs(slow[i]));
  EXPECT_NEAR(max_value, share, 1e-3 * share + 1e-5);
}

TEST(low_pass, records_too_short_to_filter_are_handed_back) {
  EXPECT_TRUE(low_pass({}, kStep, 20.0).empty());
  const std::vector<double> single = {4.0};
  EXPECT_EQ(low_pass(single, kStep, 20.0), single);
  EXPECT_THROW(low_pass(single, 0.0, 20.0), std::invalid_argument);
}

}  // namespace
}  // namespace overbend
