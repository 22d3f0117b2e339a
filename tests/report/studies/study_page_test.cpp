#include "report/studies/study_page.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "report/page_text.h"
#include "report/studies/study_data.h"
#include "report/synthetic_study.h"

namespace overbend {
namespace {

using testing::synthetic_study;

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::string render_page(const StudyResults& results) {
  return testing::shown_text(study_document(results));
}

bool draws(const std::string& shape, const std::string& panel) {
  const std::vector<std::string> panels = testing::panels(study_document(synthetic_study(shape)).body.json());
  return std::ranges::find(panels, panel) != panels.end();
}

TEST(study_page, charts_follow_from_the_shape_of_the_study) {
  EXPECT_EQ(study_shape(synthetic_study("curves")), StudyShape::curves);
  EXPECT_EQ(study_shape(synthetic_study("maps")), StudyShape::maps);
  EXPECT_EQ(study_shape(synthetic_study("facets")), StudyShape::maps);
  EXPECT_EQ(study_shape(synthetic_study("swings")), StudyShape::one_at_a_time);
  EXPECT_EQ(study_shape(synthetic_study("sample")), StudyShape::sample);
  EXPECT_TRUE(draws("maps", "study_maps/all"));
  EXPECT_TRUE(draws("sample", "study_scatter/all"));
  EXPECT_TRUE(draws("swings", "study_swings/all"));
}

TEST(study_page, groups_hold_mean_and_range_of_their_seeds) {
  StudyResults results = synthetic_study("curves");
  for (std::size_t i = 0; i < 3; ++i) results.cases[i].values[0] = 1e6 * static_cast<double>(i + 1);
  const StudyGroup group = study_groups(results).front();
  EXPECT_EQ(group.done, 3);
  EXPECT_DOUBLE_EQ(*group.mean[0], 2e6);
  EXPECT_DOUBLE_EQ(*group.low[0], 1e6);
  EXPECT_DOUBLE_EQ(*group.high[0], 3e6);
  const Json data = study_data(results);
  EXPECT_DOUBLE_EQ(data["groups"][0]["mean"][0].get<double>(), 2.0);  // MPa
}

TEST(study_page, a_group_passes_where_every_seed_does) {
  StudyResults results = synthetic_study("curves");
  ASSERT_EQ(study_groups(results).front().verdict, VerdictKind::passed);
  results.cases[1].verdict = VerdictKind::reserved;
  EXPECT_EQ(study_groups(results).front().verdict, VerdictKind::reserved);
}

TEST(study_page, failed_cases_are_listed_with_reason_and_command) {
  const std::string page = render_page(synthetic_study("maps"));
  EXPECT_TRUE(has(page, "is below the suspended weight, 163 kN"));
  EXPECT_TRUE(has(page, "overbend study waves.yaml -o waves.study --case 129"));
  EXPECT_TRUE(has(page, "3 have no result"));
}

TEST(study_page, extremes_are_shown_with_their_confidence) {
  const std::string page = render_page(synthetic_study("maps"));
  EXPECT_TRUE(has(page, "318 (306 to 333)"));
  EXPECT_TRUE(has(page, "315 (309 to 324)"));
}

TEST(study_page, operability_reports_limits_governing_checks_and_workability) {
  const std::string page = render_page(synthetic_study("operability"));
  EXPECT_TRUE(has(page, "clearance at the stinger tip"));
  EXPECT_TRUE(has(page, "over 4"));
  EXPECT_TRUE(has(page, "two seeds had no result"));
  EXPECT_TRUE(has(page, " * | "));
  EXPECT_TRUE(has(page, ": at the limit the pipe left 'stinger 8' over its side to port"));
  EXPECT_TRUE(draws("operability", "operability_rose/rose"));
  EXPECT_TRUE(has(page, "September"));
}

TEST(study_page, a_long_table_is_cut_and_says_so) {
  StudyResults results = synthetic_study("sample");
  const StudyCase study_case = results.cases.front();
  while (results.cases.size() < 1000) {
    results.cases.push_back(study_case);
    results.cases.back().number = results.cases.back().group = results.cases.size() - 1;
  }
  const Document document = study_document(results);
  EXPECT_TRUE(has(testing::section_text(document, "cases"), "The first 300 of 1000 cases"));
  EXPECT_EQ(testing::row_count(testing::section_body(document, "cases")), 300u);
}

TEST(study_page, a_value_that_is_not_a_number_reaches_the_page_as_none) {
  StudyResults results = synthetic_study("curves");
  results.cases[0].inputs[0] = std::nan("");
  results.cases[0].values[0].reset();
  EXPECT_TRUE(study_data(results)["groups"][0]["x"][0].is_null());
  EXPECT_FALSE(has(json_text(study_data(results)), "nan"));
  EXPECT_FALSE(has(render_page(results), "| nan"));
}

TEST(study_page, a_study_without_anything_that_changes_has_a_page) {
  StudyResults results = synthetic_study("curves");
  results.inputs.clear();
  results.cases.resize(1);
  results.cases[0].value_indices.clear();
  results.cases[0].value_texts.clear();
  results.cases[0].inputs.clear();
  EXPECT_TRUE(has(render_page(results), "1 of 1 cases pass"));
}

TEST(study_page, a_study_without_code_checks_does_not_say_that_any_is_passed) {
  StudyResults results = synthetic_study("curves");
  for (StudyCase& study_case : results.cases) {
    study_case.governing.clear();
    study_case.utilisation.reset();
    study_case.verdict = VerdictKind::not_judged;
  }
  const std::string all = std::to_string(results.cases.size()), page = render_page(results);
  EXPECT_TRUE(has(page, all + " of " + all + " cases solved"));
  EXPECT_TRUE(has(page, "are not judged"));
  EXPECT_FALSE(has(page, "governing check passed"));
  EXPECT_FALSE(has(page, "| passed\n"));
  for (StudyCase& study_case : results.cases) study_case.verdict = VerdictKind::passed;
  EXPECT_TRUE(has(render_page(results), all + " of " + all + " cases pass\n"));
}

TEST(study_page, rank_correlation_sees_order_alone) {
  EXPECT_DOUBLE_EQ(*rank_correlation({1, 2, 3, 4}, {1, 10, 100, 1000}), 1.0);
  EXPECT_DOUBLE_EQ(*rank_correlation({1, 2, 3, 4}, {4, 3, 2, 1}), -1.0);
  // Ranks 1 2.5 2.5 4 against 1 2 3 4: 4.5/sqrt(4.5 5)
  EXPECT_NEAR(*rank_correlation({1, 2, 2, 3}, {1, 2, 3, 4}), 4.5 / std::sqrt(4.5 * 5.0), 1e-12);
  EXPECT_FALSE(rank_correlation({1, 1, 1}, {1, 2, 3}));
  EXPECT_FALSE(rank_correlation({1, 2}, {1, 2}));
}

}  // namespace
}  // namespace overbend
