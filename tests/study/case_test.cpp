#include "study/case.h"

#include <gtest/gtest.h>

#include "app/small_lay.h"
#include "modelfile/yaml_reader.h"
#include "study/study.h"

namespace overbend {
namespace {

Description base() {
  return *read_model_text(testing::kSmallLay, "model.yaml").description;
}

YamlChange tension(const std::string& value) {
  return {"tensioner.tension", YamlChange::Kind::scalar, value};
}

TEST(case_, is_the_model_with_its_keys_set_in_the_text) {
  const Description varied = describe(base(), {"more", "More tension", {tension("350 kN")}});
  EXPECT_EQ(varied.tensioner.tension, 350e3);
  EXPECT_NE(varied.source_text.find("tension: 350 kN"), std::string::npos);
  EXPECT_EQ(varied.source_file, "model.yaml");
}

TEST(case_, of_another_duration_keeps_the_text) {
  Case longer;
  longer.duration = 77.0;
  const Description described = describe(base(), longer);
  EXPECT_EQ(described.dynamics->duration, 77.0);
  EXPECT_EQ(described.source_text, testing::kSmallLay);
}

TEST(case_, that_makes_no_model_is_refused_by_name) {
  try {
    describe(base(), {"wrong", "", {tension("350 m")}});
    FAIL();
  } catch (const std::runtime_error& fault) {
    EXPECT_NE(std::string(fault.what()).find("the case wrong: "), std::string::npos) << fault.what();
    EXPECT_NE(std::string(fault.what()).find("tensioner.tension"), std::string::npos) << fault.what();
  }
}

TEST(case_, seeds_share_a_model_and_variants_do_not) {
  const std::vector<Case> seeds = seed_cases({4, 9});
  EXPECT_TRUE(same_model(seeds[0], seeds[1]));
  EXPECT_EQ(seeds[1].name, "seed-9");
  EXPECT_EQ(seeds[1].seed, 9U);
  EXPECT_FALSE(same_model({"a", "", {tension("1 kN")}}, {"b", "", {tension("2 kN")}}));
}

TEST(study_plan, a_seed_that_is_given_twice_is_no_plan) {
  EXPECT_TRUE(std::holds_alternative<std::string>(plan_seeds({1, 2, 1}, {})));
  EXPECT_TRUE(std::holds_alternative<StudyPlan>(plan_seeds({1, 2}, {})));
}

TEST(study_plan, no_seed_at_all_is_no_plan) {
  const auto plan = plan_seeds({}, {});
  ASSERT_TRUE(std::holds_alternative<std::string>(plan));
  EXPECT_NE(std::get<std::string>(plan).find("at least one"), std::string::npos);
}

TEST(study_plan, a_single_run_is_a_case_in_the_folder_of_the_study) {
  EXPECT_EQ(case_folders(plan_single({}), "out").front(), "out");
  const auto plan = std::get<StudyPlan>(plan_seeds({1, 2}, {}));
  EXPECT_EQ(case_folders(plan, "out").back(), "out/seed-2");
}

}  // namespace
}  // namespace overbend
