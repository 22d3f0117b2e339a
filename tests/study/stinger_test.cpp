// A floating stinger in goal seeks, operations and sensitivities.
#include <gtest/gtest.h>

#include <cmath>

#include "base/json.h"
#include "model/stinger_turn.h"
#include "modelfile/seek_reader.h"
#include "modelfile/yaml_reader.h"
#include "statics/moored_lay.h"
#include "study/lay_operation.h"
#include "study/seek.h"
#include "study/sensitivity_lay.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

const std::string kFolder = std::string(OVERBEND_SOURCE_DIR) + "/validation/operation_cases/";

SeekResults sought(const std::string& seek_text) {
  const std::string file = kFolder + "HS16-tanks.yaml";
  ModelReading reading = read_model_text(testing::file_text(file) + "\nseek:\n" + seek_text, file);
  for (const std::string& line : reading.diagnostics.lines(Severity::error)) ADD_FAILURE() << line;
  const Description description = reading.description.value();
  return seek(description, read_seek(description).value()).results;
}

/// The reference reaches this angle with a tank of 260 kN; a kN turns it by 1.1e-3 rad.
TEST(stinger_seek, finds_the_weight_of_a_tank_for_an_angle) {
  const SeekResults found = sought(
      "  vary: {key: 'supports.stinger.tanks[tank 1].weight', from: 180 kN, to: 340 kN}\n"
      "  until: {result: static.stinger.angle, equals: -0.119018772066 rad}\n");
  ASSERT_TRUE(found.found) << found.why;
  EXPECT_NEAR(found.unknowns[0].answer, 260e3, 100.0);
}

TEST(stinger_seek, finds_the_ballast_for_the_angle_as_drawn) {
  const SeekResults found = sought(
      "  vary: {key: 'supports.stinger.tanks[0].ballast', from: 0, to: 0.6}\n"
      "  until: {result: static.stinger.angle, equals: 0 deg}\n");
  ASSERT_TRUE(found.found) << found.why;
  Description d = read_model(kFolder + "HS16-tanks.yaml").description.value();
  d.supports.sections[0].tanks[0].ballast = found.unknowns[0].answer;
  Model model = build_model(d);
  const LayOutcome outcome = solve_lay(model);
  ASSERT_TRUE(outcome.solution);
  EXPECT_NEAR(model.supports.sections[0].angle, 0.0, 1e-5);
}

TEST(ballast_operation, solves_its_stages_one_after_the_other) {
  const OperationResults found = solve_operation(read_model(kFolder + "HS16-ballast.yaml").description.value());
  const Json wanted = read_json(testing::file_text(kFolder + "HS16-ballast.expected.json"))["operation"]["stages"];
  ASSERT_EQ(found.stages.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    ASSERT_TRUE(found.stages[i].lay) << found.stages[i].failure->why;
    EXPECT_NEAR(found.stages[i].lay->stinger.at(0).angle, wanted[i]["stinger"]["angle"].get<double>(), 1e-4);
    EXPECT_EQ(found.stages[i].barge_ahead, 0.0);
    EXPECT_EQ(found.stages[i].stage.tank_weight, wanted[i]["weight"].get<double>());
  }
}

/// First-order changes of the lay with the stinger held where it came to rest, beside lays held there.
TEST(stinger_sensitivities, hold_the_stinger_where_it_rests) {
  Description d = read_model(kFolder + "HS16-tanks.yaml").description.value();
  Model model = build_model(d);
  const LayOutcome outcome = solve_lay(model);
  ASSERT_TRUE(outcome.solution);
  SensitivityLay lay(model, *outcome.solution);
  Description before = d, after = d;
  before.tensioner.tension = 280e3 - 10.0;
  after.tensioner.tension = 280e3 + 10.0;
  const auto pair = lay.follow(before, after);
  ASSERT_TRUE(pair);
  EXPECT_EQ(pair->before.stinger.at(0).angle, model.supports.sections[0].angle);
  EXPECT_EQ(pair->after.stinger.at(0).angle, model.supports.sections[0].angle);
  EXPECT_GT(pair->after.lay_back, pair->before.lay_back);
}

}  // namespace
}  // namespace overbend
