#include "numerics/tail_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "numerics/random_draw.h"

namespace overbend {
namespace {

TEST(tail_check, distance_of_a_sample_is_that_of_its_definition) {
  // n integral of (F_n - u)^2 / (1 - u) du over (0, 1), F_n the share of the sample below u: by the midpoint rule.
  const std::vector<double> shares = {0.1, 0.35, 0.6, 0.93};
  double integral = 0.0;
  constexpr int kCells = 2000000;
  for (int i = 0; i < kCells; ++i) {
    const double u = (i + 0.5) / kCells;
    const auto below = std::ranges::count_if(shares, [&](double share) { return share <= u; });
    integral += std::pow(static_cast<double>(below) / 4.0 - u, 2) / (1.0 - u) / kCells;
  }
  EXPECT_NEAR(upper_tail_distance(shares), 4.0 * integral, 1e-5);
}

TEST(tail_check, distance_of_uniform_samples_is_half_on_average) {  // E = 1/2 for any size
  std::mt19937_64 generator(2);
  double sum = 0.0;
  constexpr int kSamples = 4000;
  for (int i = 0; i < kSamples; ++i) {
    std::vector<double> shares(25);
    for (double& share : shares) share = uniform_draw(generator);
    std::ranges::sort(shares);
    sum += upper_tail_distance(shares) / kSamples;
  }
  EXPECT_NEAR(sum, 0.5, 0.04);
}

TEST(tail_check, an_outlier_is_a_small_chance) {
  EXPECT_NEAR(min_probability(std::vector<double>{0.01}), 1.0 - std::exp(-0.01), 1e-12);
  EXPECT_NEAR(min_probability(std::vector<double>{1.0, 0.1}), 1.0 - 1.1 * std::exp(-0.1), 1e-12);
  EXPECT_GT(min_probability(std::vector<double>{0.7, 1.7, 2.7}), 0.4);
  EXPECT_EQ(min_probability({}), 1.0);
}

}  // namespace
}  // namespace overbend
