// Goal seek over stages of a lift, against the independent answers of validation/lift_cases and against a scan of
// stages solved directly.
#include "study/goal_seek/seek_stages.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "base/json.h"
#include "modelfile/reading/seek_reader.h"
#include "modelfile/reading/yaml_reader.h"
#include "study/goal_seek/seek_run.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

const std::string kCases = std::string(OVERBEND_SOURCE_DIR) + "/validation/lift_cases/";

Description lift(const std::string& name, const std::string& seek_text, const std::vector<YamlChange>& changes = {}) {
  const std::string text = edit_yaml(testing::file_text(kCases + name + ".yaml"), changes) + "\nseek:\n" + seek_text;
  ModelReading reading = read_model_text(text, kCases + name + ".yaml");
  for (const std::string& line : reading.diagnostics.lines(Severity::error)) ADD_FAILURE() << line;
  return reading.description.value();
}

SeekResults sought(const Description& description) {
  return seek(description, read_seek(description).value()).results;
}

Json reference_stage(const std::string& name, std::size_t stage) {
  return read_json_file(kCases + name + ".json")["stages"][stage];
}

YamlChange length(std::size_t stage, const std::string& davit, double metres) {
  return {"operation.stages[" + std::to_string(stage) + "].lengths." + davit, YamlChange::Kind::scalar,
          std::to_string(metres) + " m"};
}

std::string condition(const std::string& result, double value, const std::string& unit) {
  return "    - {result: '" + result + "', equals: " + std::to_string(value) + " " + unit + "}\n";
}

// Two formulations without common code found these heights, inclinations and tensions with the lengths of the case. The
// height is known to 0.02 m, the inclination to 0.05 deg over 24 m between the davits.
TEST(seek_stages, height_and_inclination_give_back_the_lengths_of_the_reference) {
  const Json end = reference_stage("DL20-two", 4)["lines"]["pipe"]["first_end"];
  const std::string pipe = "operation.stages[near horizontal].lines.pipe.first_end.";
  const std::string text =
      "  vary: {key: 'operation.stages[near horizontal].lengths[davit *]', from: 4 m, to: 22 m}\n  until:\n" +
      condition(pipe + "z", end["z"], "m") + condition(pipe + "inclination", end["inclination"], "rad");
  for (const auto& [first, second] : {std::pair{8.5, 18.2}, {5.0, 9.0}, {12.0, 20.0}}) {
    const SeekResults found =
        sought(lift("DL20-two", text, {length(4, "davit 1", first), length(4, "davit 2", second)}));
    ASSERT_TRUE(found.found) << found.why;
    EXPECT_NEAR(found.unknowns[0].answer, 7.5, 0.05) << first;
    EXPECT_NEAR(found.unknowns[1].answer, 13.3, 0.05) << first;
    EXPECT_LT(found.residual, 1e-6);
  }
}

TEST(seek_stages, three_davits_have_one_condition_more) {
  const Json stage = reference_stage("DL12-three", 4);
  const Json end = stage["lines"]["pipe"]["first_end"];
  const std::string text_place = "operation.stages[4].";
  const std::string text =
      "  vary:\n    - {key: 'operation.stages[4].lengths.davit 1', within: 4 m}\n"
      "    - {key: 'operation.stages[4].lengths.davit 2', within: 4 m}\n"
      "    - {key: 'operation.stages[4].lengths.davit 3', within: 4 m}\n  until:\n" +
      condition(text_place + "lines.pipe.first_end.z", end["z"], "m") +
      condition(text_place + "lines[pipe].first_end.inclination", end["inclination"], "rad") +
      condition(text_place + "davits.davit 2.tension_upper", stage["davits"]["davit 2"]["tension_upper"], "N");
  const SeekResults found = sought(
      lift("DL12-three", text, {length(4, "davit 1", 8.5), length(4, "davit 2", 10.5), length(4, "davit 3", 15.5)}));
  ASSERT_TRUE(found.found) << found.why;
  EXPECT_NEAR(found.unknowns[0].answer, 7.0, 0.05);
  EXPECT_NEAR(found.unknowns[1].answer, 9.4, 0.05);
  EXPECT_NEAR(found.unknowns[2].answer, 13.6, 0.05);
}

constexpr double kHeight = 2.6, kInclination = 0.05;

const std::string kLevel =
    "  vary:\n    - {key: 'operation.stages[near horizontal].lengths[davit *]', from: 5 m, to: 19 m}\n  until:\n" +
    condition("operation.stages[near horizontal].lines.pipe.first_end.z", kHeight, "m") +
    condition("operation.stages[near horizontal].lines.pipe.first_end.inclination", kInclination, "rad") +
    "  minimise: 'operation.stages[near horizontal].lines.pipe.largest_bending_moment.value'\n";

const SeekResults& level_end() {
  static const SeekResults kFound = sought(lift("DL12-three", kLevel));
  return kFound;
}

/// Stages of DL12-three solved directly: davits 1 and 3 bring the end to its height and inclination while davit 2 has a
/// length of its own. The largest moment there; nothing where they cannot.
class LevelEnd {
 public:
  LevelEnd() : model_(lift("DL12-three", kLevel)), before_(model_) {
    for (int i = 0; i < 4; ++i) before_.next(model_.operation.lay.stages);
  }

  std::optional<double> moment(double second) {
    const auto [known, fresh] = moments_.try_emplace(second);
    const Eigen::Vector2d before = x_;
    if (fresh) known->second = solved_moment(second);
    if (!known->second) x_ = before;
    return known->second;
  }

  /// Height, inclination and largest moment.
  Vec3 values(double first, double second, double third) const {
    std::vector<LayStageDescription> stages = model_.operation.lay.stages;
    stages[4].lengths = {{"davit 1", first}, {"davit 2", second}, {"davit 3", third}};
    Lift lines = before_;
    const StageResult stage = lines.next(stages);
    const LiftedLine& pipe = stage.lay->lift->lines.front();
    return {pipe.first.location.place.z(), pipe.first.location.inclination, pipe.bending.value};
  }

 private:
  std::optional<double> solved_moment(double second) {
    for (int i = 0; i < 30; ++i) {
      const Vec3 vec3 = values(x_(0), second, x_(1));
      const Eigen::Vector2d off(vec3(0) - kHeight, vec3(1) - kInclination);
      if (off.cwiseAbs().maxCoeff() < 1e-7) return vec3(2);
      constexpr double kStep = 1e-4;
      Eigen::Matrix2d slope;
      slope.col(0) = (values(x_(0) + kStep, second, x_(1)) - vec3).head<2>() / kStep;
      slope.col(1) = (values(x_(0), second, x_(1) + kStep) - vec3).head<2>() / kStep;
      const Eigen::Vector2d step = -slope.inverse() * off;
      if (!step.allFinite()) return std::nullopt;
      x_ += step * std::min(1.0, 0.5 / step.cwiseAbs().maxCoeff());
    }
    return std::nullopt;
  }

  Description model_;
  Lift before_;
  Eigen::Vector2d x_{7.0, 13.6};
  std::map<double, std::optional<double>> moments_;
};

TEST(seek_stages, the_least_moment_is_that_of_a_scan) {
  LevelEnd direct;
  const auto moment = [&](double second) { return direct.moment(second).value_or(1e300); };
  double best = 9.4;
  for (double second = 9.0; second > 7.5; second -= 0.4) {
    if (moment(second) < moment(best)) best = second;
  }
  double low = best - 0.4, high = best + 0.4;  // golden section
  while (high - low > 0.005) {
    const double first = high - 0.618034 * (high - low), second = low + 0.618034 * (high - low);
    (moment(first) < moment(second) ? high : low) = moment(first) < moment(second) ? second : first;
  }
  const double min_value = moment(0.5 * (low + high));
  const SeekResults& found = level_end();
  ASSERT_TRUE(found.found) << found.why;
  EXPECT_NEAR(found.goals.back().reached.value(), min_value, 1e-3 * min_value);  // 5 mm of a length change it by 1 kN m
  EXPECT_NEAR(found.unknowns[1].answer, 0.5 * (low + high), 0.01);
  const Vec3 vec3 = direct.values(found.unknowns[0].answer, found.unknowns[1].answer, found.unknowns[2].answer);
  EXPECT_NEAR(vec3(0), kHeight, 1e-5);
  EXPECT_NEAR(vec3(1), kInclination, 1e-6);
}

// A davit that is slack at first has no derivative with its length.
TEST(seek_stages, the_answer_does_not_depend_on_the_lengths_to_begin_with) {
  const SeekResults& seek_results = level_end();
  ASSERT_TRUE(seek_results.found) << seek_results.why;
  const SeekResults second_seek_results = sought(
      lift("DL12-three", kLevel, {length(4, "davit 1", 9.0), length(4, "davit 2", 18.0), length(4, "davit 3", 14.0)}));
  ASSERT_TRUE(second_seek_results.found) << second_seek_results.why;
  EXPECT_NEAR(second_seek_results.goals.back().reached.value(), seek_results.goals.back().reached.value(),
              1e-4 * seek_results.goals.back().reached.value());
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(second_seek_results.unknowns[i].answer, seek_results.unknowns[i].answer, 0.01);
}

TEST(seek_stages, says_by_name_what_cannot_be_reached_and_the_nearest) {
  const SeekResults none =
      sought(lift("DL20-two",
                  "  vary: {key: 'operation.stages[4].lengths[davit *]', from: 5 m, to: 20 m}\n  until:\n"
                  "    - {result: 'operation.stages[4].lines.pipe.first_end.z', equals: 30 m}\n"
                  "    - {result: 'operation.stages[4].lines.pipe.first_end.inclination', equals: 0 deg}\n"));
  EXPECT_FALSE(none.found);
  EXPECT_NE(none.why.find("operation.stages[4].lines.pipe.first_end.z is"), std::string::npos) << none.why;
  EXPECT_NE(none.why.find("should be 30 m"), std::string::npos) << none.why;
}

TEST(seek_stages, names_the_result_that_a_stage_does_not_have) {
  const SeekResults none = sought(lift("DL20-two",
                                       "  vary: {key: 'operation.stages[4].lengths[davit *]', from: 5 m, to: 20 m}\n"
                                       "  until: {result: 'operation.stages[4].join.moment', equals: 30 kN*m}\n"));
  EXPECT_FALSE(none.found);
  EXPECT_NE(none.why.find("operation.stages[4].join.moment does not apply"), std::string::npos) << none.why;
}

TEST(seek_stages, rejects_a_key_behind_the_stages_asked_for) {
  const Description d = lift("DL20-two",
                             "  vary: {key: 'operation.stages[4].lengths.davit 1', from: 5 m, to: 20 m}\n"
                             "  until: {result: 'operation.stages[3].lines.pipe.first_end.z', equals: 3 m}\n");
  EXPECT_THROW(sought(d), SeekError);
}

// The stage does not name the davit: its length is that of the stage before.
TEST(seek_stages, begins_with_the_length_that_a_stage_keeps) {
  const SeekResults found = sought(lift("DL20-two",
                                        "  vary: {key: 'operation.stages[vessel moved].lengths.davit 1', within: 2 m}\n"
                                        "  until: {result: 'operation.stages[vessel moved].lines.pipe.first_end.z', "
                                        "equals: -4 m}\n"));
  ASSERT_TRUE(found.found) << found.why;
  EXPECT_EQ(found.unknowns[0].before, 16.2);
  EXPECT_LT(found.unknowns[0].answer, 16.2);  // 0.19 m higher than with the length kept
}

// A key of the lines themselves: every model is solved from the first stage on.
TEST(seek_stages, vary_what_stands_outside_of_the_stages) {
  const Json wanted = reference_stage("DL8-one", 1);
  const SeekResults found = sought(lift("DL8-one",
                                        "  vary: {key: environment.water_depth, from: 18 m, to: 22 m}\n  until:\n" +
                                            condition("operation.stages[half way].lines.pipe.first_end.z",
                                                      wanted["lines"]["pipe"]["first_end"]["z"], "m"),
                                        {{"environment.water_depth", YamlChange::Kind::scalar, "19 m"}}));
  ASSERT_TRUE(found.found) << found.why;
  EXPECT_NEAR(found.unknowns[0].answer, 20.0, 0.1);
}

TEST(seek_stages, the_model_with_the_answer_has_the_results_of_the_search) {
  const Description description =
      lift("DL20-two",
           "  vary: {key: 'operation.stages[near horizontal].lengths.davit 2', within: 4 m}\n"
           "  until: {result: 'operation.stages[near horizontal].lines.pipe.first_end.z', equals: 4 m}\n");
  const SeekRun run = run_seek(description, read_seek(description).value());
  ASSERT_TRUE(run.results.found && run.operation) << run.results.why;
  EXPECT_NEAR(run.operation->stages[4].lay->lift->lines.front().first.location.place.z(), 4.0, 1e-5);
  ASSERT_EQ(run.results.stages.size(), 1U);
  EXPECT_TRUE(run.results.stages[0].starts_with("- {name: near horizontal, lengths: {davit 1: 7.5 m, davit 2: "))
      << run.results.stages[0];
}

// With davit 1 out of reach of the pipe nothing holds its length.
TEST(seek_stages, reports_a_length_that_a_slack_davit_has) {
  const SeekResults found =
      sought(lift("DL20-two",
                  "  vary:\n    - {key: 'operation.stages[4].lengths.davit 1', from: 18 m, to: 22 m}\n"
                  "    - {key: 'operation.stages[4].lengths.davit 2', from: 8 m, to: 22 m}\n  until:\n"
                  "    - {result: 'operation.stages[4].lines.pipe.first_end.z', equals: 0 m}\n"
                  "  minimise: 'operation.stages[4].davits.davit 1.tension_upper'\n"));
  ASSERT_TRUE(found.found) << found.why;
  EXPECT_EQ(found.goals.back().reached, 0.0);
  ASSERT_FALSE(found.remarks.empty());
  EXPECT_NE(found.remarks.front().find("davit 1 is the length of a slack line"), std::string::npos)
      << found.remarks.front();
}

// Four davits, two lines: the gap is closed level, and the larger of both moments is least where both are the same.
TEST(seek_stages, brings_two_ends_together_level) {
  const std::string text_place = "operation.stages[ends together].";
  const SeekResults found = sought(lift(
      "TI12-closed", "  vary: {key: '" + text_place + "lengths[davit *]', within: 3 m}\n  until:\n" +
                         condition(text_place + "lines.pipe A.first_end.z", 2.4, "m") +
                         condition(text_place + "gap.dz", 0.0, "m") + condition(text_place + "gap.angle", 0.0, "deg") +
                         "  minimise: 'max(" + text_place + "lines[*].largest_bending_moment.value)'\n"));
  ASSERT_TRUE(found.found) << found.why;
  EXPECT_NEAR(found.unknowns[0].answer, found.unknowns[2].answer, 0.01);
  EXPECT_NEAR(found.unknowns[1].answer, found.unknowns[3].answer, 0.01);
}

// Collocation of the elastica and integration along the bed have 256,903 N at the winch with 150 kN at the tensioner
// (SP12, first stage); they are known to 0.2 %.
TEST(seek_stages, finds_the_tension_of_a_pull_for_that_at_its_winch) {
  const std::string file = OVERBEND_SOURCE_DIR "/validation/operation_cases/SP12";
  const Json wanted = read_json_file(file + ".expected.json")["operation"]["stages"][0]["tension"];
  const std::string text =
      edit_yaml(testing::file_text(file + ".yaml"), {{"operation.stages.tension", YamlChange::Kind::scalar, "hold"},
                                                     {"tensioner.tension", YamlChange::Kind::scalar, "120 kN"}}) +
      "\nseek:\n  vary: {key: tensioner.tension, from: 100 kN, to: 200 kN}\n  until:\n" +
      condition("operation.stages[0].tension.winch", wanted["winch"], "N");
  const Description description = read_model_text(text, file + ".yaml").description.value();
  const SeekRun run = run_seek(description, read_seek(description).value());
  ASSERT_TRUE(run.results.found && run.operation) << run.results.why;
  EXPECT_NEAR(run.results.unknowns[0].answer, wanted["tensioner"].get<double>(), 0.002 * 150e3);
  EXPECT_EQ(run.operation->stages.size(), 9U);  // all are written, though the search looked at the first alone
}

}  // namespace
}  // namespace overbend
