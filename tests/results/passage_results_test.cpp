#include "results/passage_results.h"

#include <gtest/gtest.h>

#include "report/page_text.h"
#include "report/static/passage_section.h"
#include "resultfiles/static/passage_json.h"

namespace overbend {
namespace {

StageResult stage(const char* name, double passed, double first, double second, double strain) {
  StageResult result;
  result.stage.name = name;
  result.stage.passed = passed;
  StaticResults& lay = result.lay.emplace();
  for (const auto& [box, reaction] : {std::pair{"ramp 1", first}, {"ramp 2", second}}) {
    SupportResult& support = lay.supports.emplace_back();
    support.name = box;
    support.reaction = 1.5 * reaction;
    support.rows.emplace_back().rollers.emplace_back().reaction = reaction;
  }
  StructureResult& tee = lay.structures.emplace_back();
  tee.name = "tee";
  tee.from_top = passed;
  tee.reaction = std::max(first, second);
  tee.support = first > second ? "ramp 1" : "ramp 2";
  tee.lower.strain = strain;
  lay.structures.push_back(tee);
  lay.structures.back().name = "another";
  lay.structures.back().from_top = 75.0;
  lay.structures.back().lower.strain = 1.0;
  return result;
}

PassageResults passed() {
  OperationResults operation;
  operation.type = OperationType::passage;
  operation.stages = {stage("stage 1", 10.0, 30e3, 40e3, 1e-3), stage("stage 2", 20.0, 50e3, 35e3, 2e-3)};
  operation.stages.emplace_back().stage.name = "stage 3";  // without an equilibrium
  return find_passage_maxima(operation).value();
}

}  // namespace

TEST(passage, every_box_has_its_largest_with_the_stage) {
  const PassageResults passage = passed();
  ASSERT_EQ(passage.boxes.size(), 2U);
  EXPECT_EQ(passage.boxes[0].roller.value, 50e3);
  EXPECT_EQ(passage.boxes[0].roller.passed, 20.0);
  EXPECT_EQ(passage.boxes[1].reaction.value, 60e3);
  EXPECT_EQ(passage.boxes[1].reaction.stage, "stage 1");
}

TEST(passage, is_none_of_another_operation) {
  OperationResults operation;
  operation.type = OperationType::move;
  operation.stages = {stage("stage 1", 10.0, 30e3, 40e3, 1e-3)};
  EXPECT_FALSE(find_passage_maxima(operation));
}

TEST(passage, speaks_of_the_structure_that_passes) {
  const PassageResults passage = passed();
  EXPECT_EQ(passage.reaction.value, 50e3);
  EXPECT_EQ(passage.support, "ramp 1");
  EXPECT_EQ(passage.strain.value, 2e-3);
  EXPECT_EQ(passage_json(passage)["max_strain_beside"]["stage"], "stage 2");
  EXPECT_EQ(passage_json(passage)["supports"][1]["max_roller_reaction"]["value"], 40e3);
  const std::string section = testing::shown_text(passage_section(passage));
  EXPECT_NE(section.find("0.2000 %"), std::string::npos);
  EXPECT_NE(section.find("Passage of tee"), std::string::npos);
}

}  // namespace overbend
