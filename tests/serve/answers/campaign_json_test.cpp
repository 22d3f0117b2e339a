#include "serve/answers/campaign_json.h"

#include <gtest/gtest.h>

#include <cmath>

namespace overbend {
namespace {

/// Tension by water depth; the first case is solved, the second has no solution, the third is still open.
StudyResults three_cases() {
  StudyResults results;
  results.analysis = "static";
  results.inputs = {{"tensioner.tension", "N", "kN", "", false, {"200 kN", "300 kN"}, {200e3, 300e3}},
                    {"environment.waves.type", "", "", "", false, {"airy"}, {}}};
  results.outputs = {{"static.sagbend.max_von_mises", "N/m^2", false}, {"checks.governing", "", true}};
  StudyCase solved;
  solved.value_indices = {0, 0};
  solved.value_texts = {"200 kN", "airy"};
  solved.inputs = {200e3, std::nan("")};
  solved.state = StudyCaseState::done;
  solved.values = {100e6, std::nullopt};
  solved.utilisation = 0.5;
  StudyCase failed = solved;
  failed.number = 1;
  failed.state = StudyCaseState::failed;
  failed.values.clear();
  failed.utilisation.reset();
  failed.reason = "no equilibrium";
  StudyCase open;
  open.number = 2;
  results.cases = {solved, failed, open};
  return results;
}

}  // namespace

TEST(campaign_json, numbers_are_in_the_units_shown_and_absent_ones_null) {
  const Json json = campaign_json(three_cases());
  EXPECT_EQ(json["inputs"][0]["values"][1], 300.0);
  EXPECT_EQ(json["outputs"].size(), 1U) << "texts stand with the cases";
  EXPECT_EQ(json["outputs"][0]["unit"], "MPa");
  EXPECT_EQ(json["cases"][0]["inputs"][0], 200.0);
  EXPECT_TRUE(json["cases"][0]["inputs"][1].is_null());
  EXPECT_EQ(json["cases"][0]["values"][0], 100.0);
  EXPECT_EQ(json["cases"][1]["state"], "failed");
  EXPECT_TRUE(json["cases"][1]["values"][0].is_null());
  EXPECT_TRUE(json["operability"].is_null());
}

TEST(campaign_json, a_case_that_is_still_open_has_no_values) {
  const Json open = campaign_json(three_cases())["cases"][2];
  EXPECT_EQ(open["state"], "open");
  EXPECT_TRUE(open["inputs"][0].is_null());
  EXPECT_TRUE(open["values"][0].is_null());
  EXPECT_TRUE(open["seed"].is_null());
}

}  // namespace overbend
