#include "study/campaign/study_extremes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace overbend {
namespace {

double uniform(std::mt19937_64& generator) {
  return (static_cast<double>(generator() >> 11) + 0.5) * 0x1.0p-53;
}

/// Two seas with so many seeds; outputs a largest, a smallest and a mean value.
StudyResults make_study_results(int seeds) {
  StudyResults results;
  results.outputs = {
      {"dynamic.top_tension.max", "N"}, {"dynamic.top_tension.min", "N"}, {"dynamic.lay_back.mean", "m"}};
  std::mt19937_64 generator(1);
  for (std::size_t i = 0; i < 2 * static_cast<std::size_t>(seeds); ++i) {
    StudyCase study_case;
    study_case.number = i;
    study_case.group = i / static_cast<std::size_t>(seeds);
    study_case.seed = i % static_cast<std::size_t>(seeds) + 1;
    study_case.state = StudyCaseState::done;
    const double extreme = 100.0 - 5.0 * std::log(-std::log(uniform(generator)));
    study_case.values = {extreme, -extreme, 7.0};
    results.cases.push_back(study_case);
  }
  return results;
}

TEST(study_extremes, names_say_which_outputs_are_extremes) {
  EXPECT_EQ(is_maximum_output("dynamic.overbend.max_von_mises"), true);
  EXPECT_EQ(is_maximum_output("dynamic.top_tension.max"), true);
  EXPECT_EQ(is_maximum_output("dynamic.top_tension.min"), false);
  EXPECT_EQ(is_maximum_output("dynamic.smallest_tension"), false);
  EXPECT_EQ(is_maximum_output("max(dynamic.supports[box 1].reaction)"), true);
  EXPECT_EQ(is_maximum_output("dynamic.lay_back.mean"), std::nullopt);
  EXPECT_EQ(is_maximum_output("checks.governing"), std::nullopt);
}

TEST(study_extremes, every_group_has_one_of_every_extreme) {
  StudyResults results = make_study_results(12);
  fill_extremes(results, 10800.0);
  ASSERT_EQ(results.extremes.size(), 4u);
  EXPECT_EQ(results.extremes[2].group, 1u);
  const StudyExtreme &max_value = results.extremes[0], &min_value = results.extremes[1];
  EXPECT_TRUE(max_value.is_maximum);
  EXPECT_FALSE(min_value.is_maximum);
  EXPECT_EQ(max_value.runs, 12);
  ASSERT_TRUE(max_value.enough);
  EXPECT_NEAR(max_value.gumbel.value, 100.0, 6.0);  // of three hours: the mode
  EXPECT_DOUBLE_EQ(min_value.gumbel.low, -max_value.gumbel.high);
  EXPECT_DOUBLE_EQ(min_value.worst, -max_value.worst);
  EXPECT_FALSE(max_value.acer);
}

TEST(study_extremes, few_seeds_and_failed_cases_are_not_fitted) {
  StudyResults results = make_study_results(3);
  results.cases[0].state = results.cases[1].state = StudyCaseState::failed;
  fill_extremes(results, 10800.0);
  ASSERT_EQ(results.extremes.size(), 2u);  // the first sea has a single run left
  EXPECT_EQ(results.extremes[0].group, 1u);
  EXPECT_EQ(results.extremes[0].runs, 3);
  EXPECT_FALSE(results.extremes[0].enough);
}

TEST(study_extremes, of_three_hours_are_none_where_a_line_parted_in_one_of_the_runs) {
  StudyResults results = make_study_results(12);
  results.cases[3].findings = {{FindingCode::record_not_stationary, "not stationary"}};
  const auto peaks = [](const StudyCase&) {
    return std::vector<HistoryPeaks>{{"top_tension_peak", false, {std::vector<double>(150, 2.0), 1200.0}}};
  };
  fill_extremes(results, 1200.0, peaks);
  EXPECT_FALSE(results.extremes[0].enough);
  EXPECT_FALSE(results.extremes[0].acer);
  EXPECT_TRUE(results.extremes[2].enough);  // the other sea
}

TEST(study_extremes, histories_give_an_estimate_where_there_are_too_few_seeds_for_gumbel) {
  StudyResults results = make_study_results(3);
  std::mt19937_64 generator(2);
  fill_extremes(results, 1200.0, [&](const StudyCase&) {
    HistoryPeaks peaks{"top_tension_peak", false, {{}, 1200.0}};
    for (int i = 0; i < 150; ++i) peaks.record.peaks.push_back(std::sqrt(-2.0 * std::log(uniform(generator))));
    return std::vector<HistoryPeaks>{peaks};
  });
  ASSERT_EQ(results.extremes.size(), 4u);
  ASSERT_TRUE(results.extremes[0].acer);
  EXPECT_FALSE(results.extremes[1].acer);  // no history of the smallest tension
  EXPECT_NEAR(results.extremes[0].acer->value, std::sqrt(2.0 * std::log(1350.0)), 0.5);  // 1,350 peaks in three hours
}

}  // namespace
}  // namespace overbend
