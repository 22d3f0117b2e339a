#include "numerics/pareto_tail.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "numerics/random_draw.h"

namespace overbend {
namespace {

/// Independent values of a generalised Pareto distribution beyond `threshold`.
std::vector<double> pareto_sample(std::size_t count, double threshold, double scale, double shape, unsigned seed) {
  std::mt19937_64 generator(seed);
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) {
    values.push_back(threshold + scale * (std::pow(uniform_draw(generator), -shape) - 1.0) / shape);
  }
  return values;
}

TEST(pareto_tail, gives_shape_and_scale_of_a_large_sample_back) {
  for (const double shape : {-0.3, 0.2}) {
    const std::vector<double> peaks = pareto_sample(20000, 5.0, 2.0, shape, 3);
    const ParetoTail tail = fit_pareto_tail(peaks, peaks.size()).value();
    EXPECT_TRUE(tail.described);
    // Runs of peaks count once: over the median a quarter of the peaks. The largest of runs have the tail of the peaks,
    // but are not of the law at low thresholds, which 20,000 peaks can show.
    EXPECT_LT(tail.per_peak, 0.26);
    EXPECT_GT(tail.threshold, 5.0);
    EXPECT_NEAR(tail.shape, shape, 0.08);
    const double truth = 5.0 + 2.0 * (std::pow(1e4, shape) - 1.0) / shape;  // exceeded by one in 10,000
    EXPECT_NEAR(tail.once_in(1e4), truth, 0.1 * (truth - 5.0));
    EXPECT_NEAR(1e4 * tail.per_peak * tail.above(tail.once_in(1e4)), 1.0, 1e-9);
  }
}

TEST(pareto_tail, begins_above_what_is_of_another_kind) {
  std::vector<double> peaks = pareto_sample(600, 0.0, 1.0, -0.2, 4);  // below 5
  const std::vector<double> rare = pareto_sample(60, 10.0, 8.0, 0.05, 5);
  for (std::size_t i = 0; i < rare.size(); ++i)
    peaks.insert(peaks.begin() + static_cast<std::ptrdiff_t>(11 * i), rare[i]);
  const ParetoTail tail = fit_pareto_tail(peaks, peaks.size()).value();
  EXPECT_TRUE(tail.described);
  EXPECT_GT(tail.threshold, 5.0);
  const double truth = 10.0 + 8.0 * (std::pow(60.0, 0.05) - 1.0) / 0.05;
  EXPECT_NEAR(tail.once_in(660.0), truth, 0.25 * truth);
}

TEST(pareto_tail, interval_holds_the_truth_in_most_samples) {
  int held = 0;
  const double truth = 3.0 * (std::pow(500.0, 0.1) - 1.0) / 0.1;
  for (unsigned seed = 1; seed <= 100; ++seed) {
    const std::vector<double> peaks = pareto_sample(200, 0.0, 3.0, 0.1, seed);
    const ConfidentEstimate estimate = confident(fit_pareto_tail(peaks, peaks.size()).value(), 500.0);
    held += estimate.low <= truth && truth <= estimate.high;
  }
  EXPECT_GE(held, 80);  // of 100: percentiles of a bootstrap with few exceedances are somewhat narrow
}

TEST(pareto_tail, needs_peaks_that_differ) {
  EXPECT_FALSE(fit_pareto_tail(std::vector<double>(20, 1.0), 20));
  EXPECT_FALSE(fit_pareto_tail(std::vector<double>{1.0, 2.0, 3.0}, 3));
  EXPECT_FALSE(fit_pareto_tail({}, 0));
}

}  // namespace
}  // namespace overbend
