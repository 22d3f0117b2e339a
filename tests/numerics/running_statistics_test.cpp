#include "numerics/running_statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <stdexcept>

namespace overbend {
namespace {

struct Samples {
  std::vector<std::vector<double>> rows;
  std::vector<double> weights;
};

Samples random_samples(std::size_t quantities, std::size_t count, unsigned seed) {
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> weight(0.01, 0.5);
  Samples samples;
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<double>& row = samples.rows.emplace_back(quantities);
    for (std::size_t q = 0; q < quantities; ++q) {
      row[q] = 10.0 * static_cast<double>(q) + normal(generator);
    }
    samples.weights.push_back(weight(generator));
  }
  return samples;
}

RunningStatistics taken(const Samples& samples) {
  RunningStatistics statistics(samples.rows.front().size());
  for (std::size_t i = 0; i < samples.rows.size(); ++i) {
    statistics.add(samples.rows[i], samples.weights[i]);
  }
  return statistics;
}

TEST(running_statistics, agree_with_two_passes_over_all_samples) {
  const Samples samples = random_samples(7, 500, 1);
  const RunningStatistics statistics = taken(samples);
  for (std::size_t q = 0; q < 7; ++q) {
    long double sum = 0.0L, weight = 0.0L, squares = 0.0L;
    double low = 1e300, high = -1e300;
    for (std::size_t i = 0; i < samples.rows.size(); ++i) {
      sum += samples.weights[i] * samples.rows[i][q];
      weight += samples.weights[i];
      low = std::min(low, samples.rows[i][q]);
      high = std::max(high, samples.rows[i][q]);
    }
    const long double mean = sum / weight;
    for (std::size_t i = 0; i < samples.rows.size(); ++i) {
      squares += samples.weights[i] * (samples.rows[i][q] - mean) * (samples.rows[i][q] - mean);
    }
    EXPECT_EQ(statistics.min()[q], low);
    EXPECT_EQ(statistics.max()[q], high);
    EXPECT_NEAR(statistics.mean()[q], static_cast<double>(mean), 1e-13 * 70.0);  // rounding of 500 additions
    EXPECT_NEAR(statistics.standard_deviation()[q], std::sqrt(static_cast<double>(squares / weight)), 1e-12);
    EXPECT_NEAR(statistics.weight(), static_cast<double>(weight), 1e-12);
  }
}

TEST(running_statistics, a_weight_of_three_counts_as_three_samples) {
  RunningStatistics weighted(1), repeated(1);
  const double values[] = {1.0, 4.0, -2.0, 5.0};
  const int weights[] = {3, 1, 2, 3};
  for (std::size_t i = 0; i < 4; ++i) {
    weighted.add({&values[i], 1}, weights[i]);
    for (int k = 0; k < weights[i]; ++k) {
      repeated.add({&values[i], 1}, 1.0);
    }
  }
  EXPECT_NEAR(weighted.mean()[0], repeated.mean()[0], 1e-14);
  EXPECT_NEAR(weighted.standard_deviation()[0], repeated.standard_deviation()[0], 1e-14);
}

TEST(running_statistics, keep_a_spread_that_is_a_billionth_of_the_mean) {
  RunningStatistics statistics(1);
  for (int i = 0; i < 100000; ++i) {  // sums of squares would leave no digit of it
    const double value = 1e9 + (i % 2 == 0 ? 1.0 : -1.0);
    statistics.add({&value, 1}, 0.1);
  }
  EXPECT_NEAR(statistics.standard_deviation()[0], 1.0, 1e-6);  // value and mean are rounded to 1e-7
  EXPECT_NEAR(statistics.mean()[0], 1e9, 1e-5);
}

TEST(running_statistics, a_sample_without_weight_counts_for_least_and_greatest_alone) {
  RunningStatistics statistics(1);
  const double first = 9.0, second = 2.0;
  statistics.add({&first, 1}, 0.0);
  EXPECT_EQ(statistics.max()[0], 9.0);
  EXPECT_EQ(statistics.standard_deviation()[0], 0.0);
  statistics.add({&second, 1}, 0.5);
  EXPECT_EQ(statistics.max()[0], 9.0);
  EXPECT_EQ(statistics.min()[0], 2.0);
  EXPECT_EQ(statistics.mean()[0], 2.0);
  EXPECT_EQ(statistics.standard_deviation()[0], 0.0);
}

TEST(running_statistics, a_value_that_is_not_a_number_is_absent) {
  constexpr double kAbsent = std::numeric_limits<double>::quiet_NaN();
  RunningStatistics statistics(3);
  for (const auto& [sample, weight] :
       {std::pair{std::array{1.0, kAbsent, kAbsent}, 1.0}, std::pair{std::array{2.0, 5.0, kAbsent}, 1.0},
        std::pair{std::array{3.0, 9.0, kAbsent}, 3.0}}) {
    statistics.add(sample, weight);
  }
  EXPECT_DOUBLE_EQ(statistics.mean()[0], 12.0 / 5.0);
  EXPECT_DOUBLE_EQ(statistics.mean()[1], 8.0);  // of the four seconds in which it was there
  EXPECT_DOUBLE_EQ(statistics.standard_deviation()[1], std::sqrt(3.0));
  EXPECT_EQ(statistics.min()[1], 5.0);
  EXPECT_GT(statistics.min()[2], statistics.max()[2]);  // never there
}

TEST(running_statistics, a_value_that_is_missing_from_some_time_on_leaves_the_others_as_they_are) {
  constexpr double kAbsent = std::numeric_limits<double>::quiet_NaN();
  const Samples samples = random_samples(2, 60, 3);
  RunningStatistics both(2), first(1), second(1);
  for (std::size_t i = 0; i < 60; ++i) {
    const std::array<double, 2> sample = {samples.rows[i][0], i % 7 == 6 ? kAbsent : samples.rows[i][1]};
    both.add(sample, samples.weights[i]);
    first.add(std::span(sample).first(1), samples.weights[i]);
    if (i % 7 != 6) second.add(std::span(sample).last(1), samples.weights[i]);
  }
  EXPECT_EQ(both.mean()[0], first.mean()[0]);
  EXPECT_EQ(both.standard_deviation()[0], first.standard_deviation()[0]);
  EXPECT_EQ(both.max()[0], first.max()[0]);
  EXPECT_EQ(both.mean()[1], second.mean()[0]);
  EXPECT_EQ(both.standard_deviation()[1], second.standard_deviation()[0]);
  EXPECT_EQ(both.min()[1], second.min()[0]);
}

TEST(running_statistics, a_sample_in_parts_counts_as_the_whole) {
  const Samples samples = random_samples(5, 20, 4);
  RunningStatistics whole(5), parts(5);
  for (std::size_t i = 0; i < 20; ++i) {
    const std::span<const double> all = samples.rows[i];
    whole.add(all, samples.weights[i]);
    parts.add_parts({all.first(2), all.subspan(2, 1), all.last(2)}, samples.weights[i]);
  }
  EXPECT_EQ(parts.save(), whole.save());
  EXPECT_THROW(parts.add_parts({whole.min().first(2), whole.max().first(2)}, 1.0), std::logic_error);
}

TEST(running_statistics, taken_up_again_from_what_was_saved_end_with_the_same_bits) {
  const Samples samples = random_samples(33, 100, 2);
  const std::vector<double> whole = taken(samples).save();
  Samples first = samples;
  first.rows.resize(41);
  RunningStatistics resumed;
  resumed.restore(taken(first).save());
  for (std::size_t i = 41; i < 100; ++i) {
    resumed.add(samples.rows[i], samples.weights[i]);
  }
  const std::vector<double> again = resumed.save();
  ASSERT_EQ(again.size(), whole.size());
  EXPECT_EQ(std::memcmp(again.data(), whole.data(), whole.size() * sizeof(double)), 0);
}

TEST(running_statistics, an_empty_state_can_be_saved_too) {
  RunningStatistics statistics(3), another;
  another.restore(statistics.save());
  EXPECT_EQ(another.size(), 3u);
  const std::vector<double> values{1.0, 2.0, 3.0};
  another.add(values, 1.0);
  EXPECT_EQ(another.min()[1], 2.0);
  EXPECT_EQ(another.max()[1], 2.0);
}

TEST(running_statistics, reject_what_does_not_fit) {
  RunningStatistics statistics(2);
  const std::vector<double> three(3);
  EXPECT_THROW(statistics.add(three, 1.0), std::logic_error);
  EXPECT_THROW(statistics.add(std::span(three).first(2), -1.0), std::logic_error);
  EXPECT_THROW(statistics.restore(three), std::logic_error);
}

}  // namespace
}  // namespace overbend
