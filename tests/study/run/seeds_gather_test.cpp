#include "study/run/seeds_gather.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace overbend {
namespace {

/// Quantiles of the Gumbel distribution at evenly spaced probabilities: a sample without chance.
std::vector<double> gumbel_sample(double mode, double scale, int count) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(mode - scale * std::log(-std::log((i + 0.5) / count)));
  std::shuffle(values.begin(), values.end(), std::mt19937(1));
  return values;
}

TEST(seeds_gather, finds_the_gumbel_distribution_of_a_sample_from_one) {
  const SeedStatistics s = seed_statistics(gumbel_sample(400.0, 10.0, 200), SeedExtreme::maximum, 1080.0);
  ASSERT_TRUE(s.enough);
  // Evenly spaced quantiles leave out the tail beyond 1/400, which takes a few per cent of the scale.
  EXPECT_NEAR(s.mode, 400.0, 0.3);
  EXPECT_NEAR(s.scale, 10.0, 0.3);
  EXPECT_NEAR(s.estimate, 400.0 + 10.0 * std::log(10.0), 1.0);  // ten runs in three hours
  EXPECT_LT(s.low, s.estimate);
  EXPECT_GT(s.high, s.estimate);
  EXPECT_NEAR(s.mean, 400.0 + 10.0 * 0.5772, 0.3);
}

TEST(seeds_gather, of_three_hours_the_estimate_is_the_mode) {
  const SeedStatistics s = seed_statistics(gumbel_sample(5.0, 1.0, 20), SeedExtreme::maximum, 10800.0);
  EXPECT_NEAR(s.estimate, s.mode, 1e-9);
}

TEST(seeds_gather, smallest_values_are_largest_ones_turned) {
  std::vector<double> turned = gumbel_sample(400.0, 10.0, 30);
  const SeedStatistics max_value = seed_statistics(turned, SeedExtreme::maximum, 1080.0);
  for (double& value : turned) value = -value;
  const SeedStatistics min_value = seed_statistics(turned, SeedExtreme::minimum, 1080.0);
  EXPECT_DOUBLE_EQ(min_value.mode, -max_value.mode);
  EXPECT_DOUBLE_EQ(min_value.estimate, -max_value.estimate);
  EXPECT_DOUBLE_EQ(min_value.low, -max_value.high);
  EXPECT_DOUBLE_EQ(min_value.high, -max_value.low);
  EXPECT_DOUBLE_EQ(min_value.std, max_value.std);
}

TEST(seeds_gather, no_line_is_reported_to_bear_a_push) {
  SeedsResults results;
  results.duration = 600.0;
  results.quantities = {{"smallest_mooring_tension", "N", "", SeedExtreme::minimum},
                        {"smallest_effective_tension", "N", "", SeedExtreme::minimum}};
  for (const double value : gumbel_sample(-20.0, 10.0, 12)) {
    results.runs.emplace_back().values = {std::max(0.0, -value), std::max(0.0, -value)};
  }
  fill_statistics(results);
  ASSERT_TRUE(results.statistics[0].enough);
  EXPECT_LT(results.statistics[1].estimate, 0.0);  // pipe can be pressed
  EXPECT_EQ(results.statistics[0].estimate, 0.0);
  EXPECT_EQ(results.statistics[0].low, 0.0);
}

TEST(seeds_gather, runs_of_which_one_is_not_stationary_have_no_extremes_of_three_hours) {
  SeedsResults results;
  results.duration = 600.0;
  results.quantities = {{"top_tension_max", "N", "", SeedExtreme::maximum}};
  for (const double value : gumbel_sample(20.0, 10.0, 12)) results.runs.emplace_back().values = {value};
  fill_statistics(results);
  EXPECT_TRUE(results.statistics[0].enough);
  results.runs[5].findings = {{FindingCode::record_not_stationary, "not stationary"}};
  fill_statistics(results);
  EXPECT_FALSE(results.statistics[0].enough);
  EXPECT_NEAR(results.statistics[0].mean, 20.0 + 10.0 * 0.5772, 2.0);
}

TEST(seeds_gather, few_or_equal_values_are_not_fitted) {
  EXPECT_FALSE(seed_statistics(gumbel_sample(1.0, 1.0, 9), SeedExtreme::maximum, 600.0).enough);
  EXPECT_FALSE(seed_statistics(std::vector<double>(20, 3.0), SeedExtreme::maximum, 600.0).enough);
  const SeedStatistics single = seed_statistics(std::vector<double>{3.0}, SeedExtreme::maximum, 600.0);
  EXPECT_EQ(single.mean, 3.0);
  EXPECT_EQ(single.std, 0.0);
}

TEST(seeds_gather, damage_of_welds_is_that_of_the_worst_spot_and_has_no_extreme) {
  DynamicResults run;
  run.fatigue.emplace().spots.resize(2);
  run.fatigue->spots[0].path_damage = 0.01;
  run.fatigue->spots[1].path_damage = 0.03;
  const std::vector<SeedQuantity> quantities = seed_quantities(StaticResults{}, true);
  const auto sample = std::find_if(quantities.begin(), quantities.end(),
                                   [](const SeedQuantity& quantity) { return quantity.name == "fatigue_path_damage"; });
  ASSERT_NE(sample, quantities.end());
  EXPECT_EQ(sample->extreme, SeedExtreme::none);
  const std::vector<double> values = seed_values(StaticResults{}, run, true);
  ASSERT_EQ(values.size(), quantities.size());
  EXPECT_EQ(values[static_cast<std::size_t>(sample - quantities.begin())], 0.03);
  EXPECT_EQ(seed_quantities(StaticResults{}).size(), quantities.size() - 1);
}

TEST(seeds_gather, the_deviation_is_that_of_a_sample) {
  const SeedStatistics s = seed_statistics(std::vector<double>{1.0, 2.0, 3.0, 4.0}, SeedExtreme::none, 600.0);
  EXPECT_DOUBLE_EQ(s.mean, 2.5);
  EXPECT_DOUBLE_EQ(s.std, std::sqrt(5.0 / 3.0));
  EXPECT_EQ(s.min, 1.0);
  EXPECT_EQ(s.max, 4.0);
  EXPECT_FALSE(s.enough);
}

TEST(seeds_gather, a_j_lay_has_values_of_the_sagbend_alone) {
  StaticResults statics;  // no overbend, supports, tip
  statics.stations.resize(1);
  const std::vector<SeedQuantity> quantities = seed_quantities(statics);
  EXPECT_EQ(quantities.size(), seed_values(statics, DynamicResults{}).size());
  EXPECT_EQ(quantities.front().name, "top_tension_max");
  for (const SeedQuantity& quantity : quantities) {
    EXPECT_EQ(quantity.name.find("overbend"), std::string::npos);
    EXPECT_EQ(quantity.name.find("impact"), std::string::npos);
  }
}

}  // namespace
}  // namespace overbend
