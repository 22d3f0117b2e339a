#include "numerics/running_quantiles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <stdexcept>

namespace overbend {
namespace {

struct Sample {
  double value, weight;
};

/// Values of a Weibull distribution, with weights; a fifth are zero.
std::vector<Sample> random_samples(std::size_t count, double size, unsigned seed) {
  std::mt19937_64 generator(seed);
  std::weibull_distribution<double> value(1.5, size);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  std::vector<Sample> samples;
  for (std::size_t i = 0; i < count; ++i) {
    samples.push_back({share(generator) < 0.2 ? 0.0 : value(generator), 0.01 + share(generator)});
  }
  return samples;
}

double sorted_quantile(std::vector<Sample> samples, double share) {
  std::sort(samples.begin(), samples.end(), [](const Sample& a, const Sample& b) { return a.value < b.value; });
  double total = 0.0, sum = 0.0;
  for (const Sample& sample : samples) total += sample.weight;
  for (const Sample& sample : samples) {
    sum += sample.weight;
    if (sum >= share * total) return sample.value;
  }
  return samples.back().value;
}

TEST(running_quantiles, are_those_of_the_sorted_samples_to_two_bins) {
  for (const double size : {0.3, 40.0, 7e5}) {  // finer than the first bins, and far beyond them
    const std::vector<Sample> samples = random_samples(20000, size, 3);
    RunningQuantiles quantiles(2);
    double max_value = 0.0;
    for (const Sample& sample : samples) {
      quantiles.add(std::vector<double>{1.0, sample.value}, sample.weight);
      max_value = std::max(max_value, sample.value);
    }
    const double bins = std::max(1.0, 2.0 * max_value / RunningQuantiles::kBins);
    for (const double share : {0.25, 0.5, 0.9, 0.99, 1.0}) {
      EXPECT_NEAR(quantiles.at(1, share), sorted_quantile(samples, share), bins) << size << ' ' << share;
    }
    EXPECT_EQ(quantiles.at(1, 0.15), 0.0);                // a fifth of the time at zero
    EXPECT_NEAR(quantiles.at(0, 0.5), 1.5, 0.5 + 1e-12);  // in the second of the first bins
  }
}

TEST(running_quantiles, without_samples_are_zero) {
  EXPECT_EQ(RunningQuantiles(1).at(0, 0.5), 0.0);
}

TEST(running_quantiles, come_back_from_a_checkpoint_bit_for_bit) {
  RunningQuantiles whole(1), first(1), second;
  const std::vector<Sample> samples = random_samples(500, 1e4, 5);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const std::vector<double> value{samples[i].value};
    whole.add(value, samples[i].weight);
    if (i == 250) second.restore(first.save());
    (i < 250 ? first : second).add(value, samples[i].weight);
  }
  EXPECT_EQ(second.save(), whole.save());
  EXPECT_THROW(second.restore(std::vector<double>(7)), std::logic_error);
}

TEST(running_quantiles, reject_what_is_negative_or_not_a_finite_number) {
  RunningQuantiles quantiles(1);
  EXPECT_THROW(quantiles.add(std::vector<double>{std::numeric_limits<double>::infinity()}, 1.0), std::logic_error);
  EXPECT_THROW(quantiles.add(std::vector<double>{-1.0}, 1.0), std::logic_error);
  EXPECT_THROW(quantiles.add(std::vector<double>{std::numeric_limits<double>::quiet_NaN()}, 1.0), std::logic_error);
  EXPECT_THROW(quantiles.add(std::vector<double>{1.0}, -1.0), std::logic_error);
  EXPECT_THROW(quantiles.add(std::vector<double>{1.0, 2.0}, 1.0), std::logic_error);
}

}  // namespace
}  // namespace overbend
