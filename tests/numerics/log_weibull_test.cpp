#include "numerics/log_weibull.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace overbend {
namespace {

/// Sample of a Weibull variable's logarithm, ascending.
std::vector<double> sample(std::size_t count, double location, double scale, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  std::exponential_distribution<double> exponential;
  std::vector<double> y(count);
  std::generate(y.begin(), y.end(), [&] { return location + scale * std::log(exponential(generator)); });
  std::sort(y.begin(), y.end());
  return y;
}

/// Log-likelihood of a tail with `below` smaller values, straight from the distribution's formula.
double log_likelihood(std::span<const double> tail, std::size_t below, double location, double scale) {
  double sum = static_cast<double>(below) * std::log(-std::expm1(-std::exp((tail.front() - location) / scale)));
  for (const double y : tail) {
    const double z = (y - location) / scale;
    sum += z - std::exp(z) - std::log(scale);
  }
  return sum;
}

TEST(log_weibull, fit_gives_the_parameters_of_a_large_sample_back_with_and_without_its_lower_half) {
  const std::vector<double> y = sample(100000, 2.0, 0.4, 1);
  for (const std::size_t below : {std::size_t{0}, y.size() / 2}) {
    const auto fit = fit_log_weibull(std::span(y).subspan(below), below);
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->location, 2.0, 4.0 * std::sqrt(fit->variance[0]));
    EXPECT_NEAR(fit->scale, 0.4, 4.0 * std::sqrt(fit->variance[2]));
    EXPECT_LT(std::sqrt(fit->variance[0]), 0.003);  // so that four of them say something
    EXPECT_LT(std::sqrt(fit->variance[2]), 0.003);
  }
}

TEST(log_weibull, nothing_near_is_likelier_than_the_fit) {
  const std::vector<double> y = sample(60, -3.0, 7.0, 2);
  for (const std::size_t below : {0u, 30u, 50u}) {
    const std::span<const double> tail = std::span(y).subspan(below);
    const auto fit = fit_log_weibull(tail, below);
    ASSERT_TRUE(fit);
    const double best = log_likelihood(tail, below, fit->location, fit->scale);
    for (const double d : {-1e-3, 1e-3}) {
      EXPECT_LT(log_likelihood(tail, below, fit->location + d * fit->scale, fit->scale), best);
      EXPECT_LT(log_likelihood(tail, below, fit->location, fit->scale * (1.0 + d)), best);
    }
  }
}

TEST(log_weibull, variance_is_the_inverse_curvature_of_the_likelihood) {
  const std::vector<double> y = sample(80, 1.0, 0.5, 3);
  const std::size_t below = 40;
  const std::span<const double> tail = std::span(y).subspan(below);
  const auto fit = fit_log_weibull(tail, below);
  ASSERT_TRUE(fit);
  const double h = 1e-4;
  const auto l = [&](int i, int j) { return log_likelihood(tail, below, fit->location + i * h, fit->scale + j * h); };
  const double aa = -(l(1, 0) - 2.0 * l(0, 0) + l(-1, 0)) / (h * h);
  const double bb = -(l(0, 1) - 2.0 * l(0, 0) + l(0, -1)) / (h * h);
  const double ab = -(l(1, 1) - l(1, -1) - l(-1, 1) + l(-1, -1)) / (4.0 * h * h);
  const double det = aa * bb - ab * ab;
  EXPECT_NEAR(fit->variance[0], bb / det, 1e-4 * bb / det);  // differences of second order in h/scale
  EXPECT_NEAR(fit->variance[1], -ab / det, 1e-4 * bb / det);
  EXPECT_NEAR(fit->variance[2], aa / det, 1e-4 * aa / det);
}

TEST(log_weibull, fit_moves_with_shift_and_stretch_of_the_sample) {
  std::vector<double> y = sample(50, 0.0, 1.0, 4);
  const auto before = fit_log_weibull(std::span(y).subspan(20), 20);
  for (double& value : y) {
    value = 1e6 + 1e-3 * value;
  }
  const auto after = fit_log_weibull(std::span(y).subspan(20), 20);
  ASSERT_TRUE(before && after);
  EXPECT_NEAR(after->location, 1e6 + 1e-3 * before->location, 1e-8);  // rounding of 1e6
  EXPECT_NEAR(after->scale, 1e-3 * before->scale, 1e-9);
}

TEST(log_weibull, interval_holds_the_truth_in_95_of_100_samples_small_censored_and_large) {
  struct Case {
    std::size_t tail, below;
    double reduced;
  };
  for (const Case& c : {Case{10, 0, -5.0}, Case{15, 15, 1.95}, Case{250, 250, 1.95}}) {
    int held = 0;
    for (std::uint64_t seed = 100; seed < 300; ++seed) {
      const std::vector<double> y = sample(c.tail + c.below, 3.0, 2.0, seed);
      const auto fit = fit_log_weibull(std::span(y).subspan(c.below), c.below);
      ASSERT_TRUE(fit);
      const ConfidentEstimate estimate = confident(*fit, c.tail, c.below, c.reduced);
      EXPECT_LT(estimate.low, estimate.value);
      EXPECT_GT(estimate.high, estimate.value);
      const double truth = 3.0 + 2.0 * c.reduced;
      held += estimate.low <= truth && truth <= estimate.high;
    }
    EXPECT_GE(held, 178) << c.tail;  // 190 +- four binomial deviations of 3
    EXPECT_LE(held, 199) << c.tail;
  }
}

TEST(log_weibull, odd_tails_are_fitted_too) {
  const std::vector<std::vector<double>> tails{
      {1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 9.0},      // one far out
      {-700.0, -700.0, 0.0, 0.1, 0.2, 0.2, 0.2, 0.3, 0.3},     // two that are next to nothing
      {2.0, 2.0, 2.0, 2.0 + 1e-15, 2.0 + 2e-15, 2.0 + 3e-15},  // equal but for rounding
      {0.0, 1.0},
      {0.0, 0.0, 0.0, 5.0, 5.0, 5.0, 5.0, 5.0, 5.0}};
  for (const std::vector<double>& tail : tails) {
    for (const std::size_t below : {0u, 1u, 10u, 10000u}) {
      const auto fit = fit_log_weibull(tail, below);
      ASSERT_TRUE(fit) << "from " << tail.front() << " to " << tail.back() << ", below " << below;
      EXPECT_GT(fit->scale, 0.0);
      EXPECT_TRUE(std::isfinite(fit->location));
      EXPECT_GT(fit->variance[0], 0.0);
      EXPECT_GT(fit->variance[2], 0.0);
    }
  }
}

TEST(log_weibull, equal_values_can_not_be_fitted) {
  const std::vector<double> y(30, 5.0);
  EXPECT_FALSE(fit_log_weibull(y, 0));
  EXPECT_FALSE(fit_log_weibull(std::span(y).first(1), 10));
}

}  // namespace
}  // namespace overbend
