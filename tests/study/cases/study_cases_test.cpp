#include "study/cases/study_cases.h"

#include <gtest/gtest.h>

#include <cmath>

namespace overbend {
namespace {

StudyDescription two_axes() {
  StudyDescription study;
  study.axes = {{"tensioner.tension", {"200 kN", "300 kN"}, "", 0},
                {"environment.waves.type", {"jonswap", "airy", "none"}, "", 0},
                {"environment.water_depth", {"80 m", "90 m"}, "tensioner.tension", 0}};
  return study;
}

TEST(study_cases, the_first_axis_changes_slowest_and_the_seed_fastest) {
  StudyDescription study = two_axes();
  study.seeds = {4, 9};
  const StudyCases cases(study);
  ASSERT_EQ(cases.count(), 12U);
  const StudyCase study_case = cases.at(9);  // group 4: second tension, second type; second seed
  EXPECT_EQ(study_case.group, 4U);
  EXPECT_EQ(study_case.value_texts, (std::vector<std::string>{"300 kN", "airy", "90 m"}));
  EXPECT_EQ(study_case.value_indices, (std::vector<std::size_t>{1, 1, 1}));
  EXPECT_EQ(study_case.seed, 9U);
  EXPECT_EQ(study_case.inputs[0], 300e3);
  EXPECT_TRUE(std::isnan(study_case.inputs[1]));
}

TEST(study_cases, an_axis_that_changes_with_another_is_not_crossed) {
  const StudyCases cases(two_axes());
  ASSERT_EQ(cases.count(), 6U);
  EXPECT_EQ(cases.at(2).value_texts[2], "80 m");
  EXPECT_EQ(cases.at(3).value_texts[2], "90 m");
}

TEST(study_cases, a_sample_is_crossed_with_the_axes) {
  StudyDescription study = two_axes();
  SampledKey key;
  key.key = "tensioner.x";
  key.unit = key.show = "m";
  key.from = -50.0;
  key.to = -45.0;
  study.sample = StudySample{4, 1, {key}};
  const StudyCases cases(study);
  ASSERT_EQ(cases.count(), 24U);
  EXPECT_EQ(cases.inputs().back().sampled, true);
  // The same draw at every combination of the axes.
  EXPECT_EQ(cases.at(1).value_texts.back(), cases.at(21).value_texts.back());
  EXPECT_NE(cases.at(1).value_texts.back(), cases.at(2).value_texts.back());
  // The number is that of the text in the model, which has nine digits.
  EXPECT_NEAR(cases.at(1).inputs.back(), std::stod(cases.at(1).value_texts.back()), 1e-12);
}

TEST(study_cases, a_draw_that_the_key_rejects_stands_as_it_was_drawn) {
  StudyDescription study;
  SampledKey friction;
  friction.key = "environment.seabed.friction";
  friction.unit = "1";
  friction.from = -2.0;
  friction.to = -1.0;
  study.sample = StudySample{};
  study.sample->count = 4;
  study.sample->keys = {friction};
  const StudyCases cases(study);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_LT(cases.at(i).inputs[0], -1.0) << cases.at(i).value_texts[0];
    EXPECT_NEAR(cases.at(i).inputs[0], std::stod(cases.at(i).value_texts[0]), 1e-6);
  }
}

TEST(study_cases, folders_hold_at_most_a_thousand_entries) {
  EXPECT_EQ(case_folder(0), "cases/0000/000000000");
  EXPECT_EQ(case_folder(12345), "cases/0012/000012345");
  EXPECT_EQ(case_folder(999999), "cases/0999/000999999");
}

TEST(study_cases, statics_start_from_the_middle_of_their_group_of_eight_along_the_last_axis) {
  StudyDescription study;
  study.axes = {{"environment.waves.type", {"jonswap", "airy"}, "", 0}, {"tensioner.tension", {}, "", 0}};
  for (int i = 0; i < 20; ++i) study.axes[1].values.push_back(std::to_string(200 + i) + " kN");
  const StudyCases cases(study);
  EXPECT_EQ(cases.anchors(0), (std::vector<std::size_t>{4, 12}));
  EXPECT_EQ(cases.anchors(12), (std::vector<std::size_t>{12, 4, 19}));
  EXPECT_EQ(cases.anchors(20), (std::vector<std::size_t>{24, 32}));  // the next row
  EXPECT_EQ(cases.anchors(39), (std::vector<std::size_t>{39, 32}));
}

}  // namespace
}  // namespace overbend
