#include "study/sampling/latin_hypercube.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/constants.h"

namespace overbend {
namespace {

SampledKey make_sampled_key(Distribution of) {
  SampledKey key;
  key.key = "tensioner.tension";
  key.distribution = of;
  key.from = -kInfinity;
  key.to = kInfinity;
  return key;
}

SampledKey uniform(double from, double to) {
  SampledKey key = make_sampled_key(Distribution::uniform);
  key.from = from;
  key.to = to;
  return key;
}

SampledKey normal(double mean, double std) {
  SampledKey key = make_sampled_key(Distribution::normal);
  key.mean = mean;
  key.std = std;
  return key;
}

TEST(latin_hypercube, every_key_has_one_draw_in_each_of_the_equally_probable_ranges) {
  const StudySample sample{40, 7, {uniform(2.0, 6.0), uniform(-1.0, 0.0)}};
  const auto draws = latin_hypercube(sample);
  ASSERT_EQ(draws.size(), 40U);
  for (std::size_t k = 0; k < 2; ++k) {
    const SampledKey& key = sample.keys[k];
    std::vector<int> count(40, 0);
    for (const auto& draw : draws)
      ++count.at(static_cast<std::size_t>(40.0 * (draw[k] - key.from) / (key.to - key.from)));
    EXPECT_EQ(std::ranges::count(count, 1), 40);
  }
}

TEST(latin_hypercube, keys_go_together_at_random) {
  const auto draws = latin_hypercube({2000, 3, {uniform(0.0, 1.0), uniform(0.0, 1.0)}});
  double product = 0.0;
  for (const auto& draw : draws) product += (draw[0] - 0.5) * (draw[1] - 0.5);
  // Correlation of independent keys: standard deviation 1 / sqrt(2000) = 0.022.
  EXPECT_LT(std::abs(12.0 * product / 2000.0), 0.08);
}

TEST(latin_hypercube, draws_depend_on_the_seed_alone) {
  const StudySample sample{5, 11, {normal(0.0, 1.0)}};
  EXPECT_EQ(latin_hypercube(sample), latin_hypercube(sample));
  EXPECT_NE(latin_hypercube(sample), latin_hypercube({5, 12, sample.keys}));
}

/// Probabilities of the normal distribution by tables (Abramowitz and Stegun 1964, table 26.1).
TEST(latin_hypercube, normal_quantiles_are_those_of_tables) {
  EXPECT_NEAR(quantile(normal(0.0, 1.0), 0.5), 0.0, 1e-12);
  EXPECT_NEAR(quantile(normal(0.0, 1.0), 0.8413447460685429), 1.0, 1e-12);
  EXPECT_NEAR(quantile(normal(0.0, 1.0), 0.0227501319481792), -2.0, 1e-12);
  EXPECT_NEAR(quantile(normal(10.0, 2.0), 0.9986501019683699), 16.0, 1e-10);
}

/// Mean and standard deviation of the key itself by integration of the quantile over the probability.
TEST(latin_hypercube, lognormal_mean_and_deviation_are_those_of_the_key) {
  SampledKey key = make_sampled_key(Distribution::lognormal);
  key.mean = 3.0;
  key.std = 0.6;
  double sum = 0.0, squares = 0.0;
  constexpr int kCount = 20000;
  for (int i = 0; i < kCount; ++i) {
    const double x = quantile(key, (i + 0.5) / kCount);
    sum += x / kCount;
    squares += x * x / kCount;
  }
  EXPECT_NEAR(sum, 3.0, 1e-4);
  EXPECT_NEAR(std::sqrt(squares - sum * sum), 0.6, 1e-3);
}

TEST(latin_hypercube, weibull_and_triangular_quantiles_are_the_closed_forms) {
  SampledKey weibull = make_sampled_key(Distribution::weibull);
  weibull.scale = 2.0;
  weibull.shape = 1.5;
  EXPECT_NEAR(quantile(weibull, 1.0 - std::exp(-1.0)), 2.0, 1e-12);
  SampledKey triangular = make_sampled_key(Distribution::triangular);
  triangular.from = 0.0;
  triangular.to = 4.0;
  triangular.mode = 1.0;
  EXPECT_NEAR(quantile(triangular, 0.25), 1.0, 1e-12);  // area below the mode
  EXPECT_NEAR(quantile(triangular, 1.0 - 0.5 * 1.0 * (0.5 / 3.0)), 3.0, 1e-12);
}

TEST(latin_hypercube, bounds_cut_a_distribution_off_and_what_is_left_fills_it) {
  SampledKey key = normal(0.0, 1.0);
  key.from = 0.0;
  key.bounded = true;
  EXPECT_NEAR(quantile(key, 0.0), 0.0, 1e-12);
  // Half of the half above zero: the upper quartile of the whole.
  EXPECT_NEAR(quantile(key, 0.5), 0.6744897501960817, 1e-10);
}

}  // namespace
}  // namespace overbend
