// A floating stinger in goal seeks, operations and sensitivities.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "base/json.h"
#include "model/vessel/stinger_rotation.h"
#include "modelfile/reading/seek_reader.h"
#include "modelfile/reading/yaml_reader.h"
#include "statics/moored/moored_lay.h"
#include "statics/recovery/recovery.h"
#include "study/goal_seek/seek.h"
#include "study/sensitivity/sensitivity_lay.h"
#include "study/stages/lay_operation.h"
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
  const ModelEquilibrium outcome = solve_lay(model);
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

/// The lay as solved in full, stinger and all.
StaticResults solved(const Description& d) {
  Model model = build_model(d);
  const ModelEquilibrium outcome = solve_lay(model);
  return recover_statics(model, outcome.solution.value());
}

using Change = std::function<void(Description&, double)>;

/// First-order changes of the lay against lays solved in full, in which the stinger turns. These need a way that stands
/// out of how well a rest is found; of the first no contact may change, and rollers are stiff.
void expect_full_changes(const Change& change, double distance) {
  constexpr double kShort = 0.01;  // of the way
  constexpr double kRest = 2.0;    // of reactions, to which lays solved apart from each other agree [N]
  const Description d = read_model(OVERBEND_SOURCE_DIR "/examples/floating_stinger.yaml").description.value();
  Model model = build_model(d);
  const ModelEquilibrium outcome = solve_lay(model);
  ASSERT_TRUE(outcome.solution);
  SensitivityLay lay(model, *outcome.solution);
  const auto changed = [&](double by) {
    Description second_description = d;
    change(second_description, by);
    return second_description;
  };
  const auto pair = lay.neighbouring_equilibria(changed(-kShort * distance), changed(kShort * distance));
  ASSERT_TRUE(pair);
  const StaticResults low = solved(changed(-distance)), high = solved(changed(distance));
  const auto compare = [&](const char* what, const auto& value, double rest = 0.0) {
    const double full = value(high) - value(low);
    EXPECT_NEAR((value(pair->after) - value(pair->before)) / kShort, full, 0.02 * std::abs(full) + rest) << what;
  };
  compare("angle", [](const StaticResults& r) { return r.stinger.at(0).angle; });
  compare("departure", [](const StaticResults& r) { return r.departure_angle; });
  for (std::size_t box = 0; box < low.supports.size(); ++box) {
    if (low.supports[box].reaction < 1e3) continue;
    compare(
        low.supports[box].name.c_str(), [box](const StaticResults& r) { return r.supports[box].reaction; }, kRest);
  }
}

TEST(stinger_sensitivities, of_tension_let_the_stinger_turn) {
  expect_full_changes([](Description& d, double by) { *d.tensioner.tension += by; }, 1000.0);
}

TEST(stinger_sensitivities, of_a_tank_turn_the_stinger) {
  expect_full_changes([](Description& d, double by) { d.supports.sections[0].tanks[0].weight += by; }, 500.0);
}

}  // namespace
}  // namespace overbend
