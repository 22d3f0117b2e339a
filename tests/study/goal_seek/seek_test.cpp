// Goal seek against independent answers: validation/seek_cases, by spectral collocation of the planar elastica.
#include "study/goal_seek/seek.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "base/json.h"
#include "modelfile/reading/seek_reader.h"
#include "modelfile/reading/yaml_reader.h"
#include "study/goal_seek/seek_run.h"
#include "study/lay_on_its_last_box.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

const std::string kCases = std::string(OVERBEND_SOURCE_DIR) + "/validation/seek_cases/";

struct SoughtCase {
  SeekOutcome outcome;
  Json goal;  ///< Expected values.
};

const SoughtCase& sought(const std::string& name) {
  static std::map<std::string, SoughtCase> cases;
  const auto [found, fresh] = cases.try_emplace(name);
  if (fresh) {
    const Description description = read_model(kCases + name + ".yaml").description.value();
    found->second.outcome = seek(description, read_seek(description).value());
    found->second.goal = read_json(testing::file_text(kCases + name + ".expected.json"))["goal"];
  }
  return found->second;
}

/// The answer within the tolerance of the result, 0.2 % of it (tension, stress) or `of_result`, over the slope.
void expect_answer(const std::string& name, double of_result) {
  const auto& [outcome, goal] = sought(name);
  ASSERT_TRUE(outcome.results.found) << outcome.results.why;
  const double slope = goal["slope_of_result_per_unit_of_answer"];
  EXPECT_NEAR(outcome.results.unknowns[0].answer, goal["answer"].get<double>(), of_result / std::abs(slope)) << name;
  EXPECT_NEAR(outcome.results.goals[0].reached.value(), goal["target"].get<double>(),
              1e-6 * std::abs(goal["target"].get<double>()));
  EXPECT_NEAR(outcome.results.goals[0].slope.at(0), slope, 0.02 * std::abs(slope)) << name;
  EXPECT_EQ(outcome.results.monotone, goal["monotone_over_range"].get<bool>());
  EXPECT_TRUE(outcome.results.others.empty());
  EXPECT_LT(outcome.results.evaluations, 40);
}

TEST(seek, finds_the_tension_for_a_sagbend_stress) {
  expect_answer("GS16-stress", 0.003 * 65e6);
}

TEST(seek, finds_the_tension_for_a_tip_clearance) {
  expect_answer("GS16-clearance", 5e-3);
}

TEST(seek, finds_the_depth_for_a_sagbend_stress) {
  expect_answer("GS16-depth", 0.003 * 66e6);
}

TEST(seek, finds_the_tension_for_an_angle_of_the_tower) {
  expect_answer("GS12-J-angle", 0.05 * 3.14159265 / 180.0);
}

Description j_lay(const std::string& seek_text) {
  std::string text = testing::file_text(kCases + "GS12-J-angle.yaml");
  text = text.substr(0, text.find("\nseek:")) + "\nseek:\n" + seek_text;
  ModelReading reading = read_model_text(text, kCases + "GS12-J-angle.yaml");
  for (const std::string& line : reading.diagnostics.lines(Severity::error)) ADD_FAILURE() << line;
  return reading.description.value();
}

SeekResults run_seek_text(const std::string& seek_text) {
  const Description description = j_lay(seek_text);
  return seek(description, read_seek(description).value()).results;
}

TEST(seek, a_limit_is_kept_by_the_least_value_of_the_key) {
  // The bottom tension grows with the top tension: at least 300 kN holds from one tension on.
  const std::string vary = "  vary: {key: tensioner.tension, from: 450 kN, to: 1100 kN}\n";
  const SeekResults min_value = run_seek_text(vary + "  until: {result: static.bottom_tension, at_least: 300 kN}\n");
  const SeekResults equal = run_seek_text(vary + "  until: {result: static.bottom_tension, equals: 300 kN}\n");
  ASSERT_TRUE(min_value.found && equal.found);
  EXPECT_NEAR(min_value.unknowns[0].answer, equal.unknowns[0].answer, 5.0);
  EXPECT_GE(min_value.goals[0].reached.value(), 300e3);
  const SeekResults max_value = run_seek_text(vary + "  until: {result: static.bottom_tension, at_most: 300 kN}\n");
  ASSERT_TRUE(max_value.found);
  EXPECT_EQ(max_value.unknowns[0].answer, 450e3);
  EXPECT_TRUE(max_value.unknowns[0].at_bound);
}

TEST(seek, finds_the_same_by_a_name_by_object) {
  const std::string vary = "  vary: {key: tensioner.tension, from: 450 kN, to: 1100 kN}\n";
  const SeekResults by_kind = run_seek_text(vary + "  until: {result: static.bottom_tension, equals: 300 kN}\n");
  const SeekResults by_object =
      run_seek_text(vary + "  until: {result: 'lines[pipe].static.bottom_tension', equals: 300 kN}\n");
  ASSERT_TRUE(by_kind.found && by_object.found);
  EXPECT_EQ(by_object.unknowns[0].answer, by_kind.unknowns[0].answer);
  EXPECT_EQ(by_object.goals[0].result, "lines[pipe].static.bottom_tension");
}

TEST(seek, says_what_is_reached_where_there_is_no_answer) {
  const SeekResults none = run_seek_text(
      "  vary: {key: tensioner.tension, from: 450 kN, to: 600 kN}\n"
      "  until: {result: static.top_inclination, equals: 85 deg}\n");
  EXPECT_FALSE(none.found);
  EXPECT_NE(none.why.find("it goes from"), std::string::npos) << none.why;
  EXPECT_NE(none.why.find("85 deg"), std::string::npos) << none.why;
}

TEST(seek, two_keys_meet_two_conditions) {
  // Tension and depth of a J-lay from the angle and the bottom tension that they lead to.
  const SeekResults both = run_seek_text(
      "  vary:\n"
      "    - {key: tensioner.tension, from: 450 kN, to: 700 kN}\n"
      "    - {key: environment.water_depth, from: 350 m, to: 450 m}\n"
      "  until:\n"
      "    - {result: static.top_inclination, equals: 65 deg}\n"
      "    - {result: static.bottom_tension, equals: 207109.413807 N}\n");
  ASSERT_TRUE(both.found) << both.why;
  // The reference of GS12-J-angle has both at 400 m and 502.468 kN.
  EXPECT_NEAR(both.unknowns[0].answer, 502468.169, 0.001 * 502468.0);
  EXPECT_NEAR(both.unknowns[1].answer, 400.0, 0.5);
}

TEST(seek, what_is_minimised_stops_at_its_condition) {
  const SeekResults min_value = run_seek_text(
      "  vary: {key: tensioner.tension, from: 450 kN, to: 1100 kN}\n"
      "  until: {result: static.sagbend.max_bending_stress, at_most: 90 MPa}\n"
      "  minimise: static.top_tension\n");
  const SeekResults equal = run_seek_text(
      "  vary: {key: tensioner.tension, from: 450 kN, to: 1100 kN}\n"
      "  until: {result: static.sagbend.max_bending_stress, equals: 90 MPa}\n");
  ASSERT_TRUE(min_value.found && equal.found) << min_value.why << equal.why;
  EXPECT_NEAR(min_value.unknowns[0].answer, equal.unknowns[0].answer, 1e-3 * equal.unknowns[0].answer);
}

constexpr const char* kHeights =
    "seek:\n  vary:\n"
    "    - {key: 'supports.stinger.boxes[S5].offset', from: -0.5 m, to: 0.5 m}\n"
    "    - {key: 'supports.stinger.boxes[S4].offset', from: -0.5 m, to: 0.5 m}\n";

SeekResults sought_on_the_last_box(const std::string& keys) {
  const Description description = testing::lay_on_its_last_box(keys);
  return seek(description, read_seek(description).value()).results;
}

/// If the pipe lies on the box, its clearance hardly changes with any key: derivatives do not lead off it.
TEST(seek, a_clearance_is_found_though_the_pipe_lies_on_the_box_to_begin_with) {
  const SeekResults cleared = sought_on_the_last_box(
      "seek:\n  vary:\n"
      "    - {key: tensioner.tension, from: 200 kN, to: 900 kN}\n"
      "    - {key: 'supports.stinger.boxes[S5].offset', from: -1 m, to: 0.2 m}\n"
      "  until: {result: static.stinger_tip_clearance, at_least: 0.3 m}\n");
  ASSERT_TRUE(cleared.found) << cleared.why;
  EXPECT_GE(cleared.goals[0].reached.value(), 0.3 * (1.0 - 1e-6));  // the tolerance of conditions
  const SeekResults heights = sought_on_the_last_box(
      kHeights + std::string("  until: {result: static.stinger_tip_clearance, at_least: 0.1 m}\n"));
  ASSERT_TRUE(heights.found) << heights.why;
  EXPECT_GE(heights.goals[0].reached.value(), 0.1 * (1.0 - 1e-6));
}

/// The least change of the keys is asked for, wherever the search began: the condition is met and no more than that.
TEST(seek, an_answer_found_from_elsewhere_in_the_bounds_is_the_one_nearest_to_the_model) {
  const SeekResults found = sought_on_the_last_box(
      kHeights + std::string("  until: {result: static.stinger_tip_clearance, at_least: 0.1 m}\n"));
  ASSERT_TRUE(found.found) << found.why;
  EXPECT_NEAR(found.goals[0].reached.value(), 0.1, 1e-4);  // the search settles to a thousandth of its aim
  EXPECT_FALSE(found.remarks.empty());
}

TEST(seek, what_is_minimised_is_found_though_its_condition_does_not_hold_to_begin_with) {
  const SeekResults found =
      sought_on_the_last_box(kHeights + std::string("  until: {result: static.stinger_tip_clearance, at_least: 0.1 m}\n"
                                                    "  minimise: static.overbend.max_strain\n"));
  ASSERT_TRUE(found.found) << found.why;
  EXPECT_GE(found.goals[0].reached.value(), 0.1 * (1.0 - 1e-6));
}

TEST(seek, conditions_that_nothing_within_the_bounds_meets_say_what_was_looked_at) {
  const SeekResults none = sought_on_the_last_box(
      kHeights + std::string("  until: {result: static.stinger_tip_clearance, at_least: 20 m}\n"));
  EXPECT_FALSE(none.found);
  EXPECT_NE(none.why.find("4 best of 25 points within the bounds"), std::string::npos) << none.why;
  EXPECT_NE(none.why.find("should be at least 20 m"), std::string::npos) << none.why;
}

TEST(seek, ends_before_the_next_model_when_it_is_cancelled) {
  const Description description = j_lay(
      "  vary: {key: tensioner.tension, from: 450 kN, to: 1100 kN}\n"
      "  until: {result: static.top_inclination, equals: 65 deg}\n");
  int asked = 0;
  EXPECT_THROW(seek(description, read_seek(description).value(), [&] { return ++asked == 4; }), Interrupted);
  EXPECT_EQ(asked, 4);
}

TEST(seek, the_model_is_written_with_its_comments_and_the_answer) {
  const Description description = j_lay(
      "  vary: {key: tensioner.tension, from: 450 kN, to: 1100 kN}  # kept\n"
      "  until: {result: static.top_inclination, equals: 65 deg}\n");
  const SeekRun run = run_seek(description, read_seek(description).value());
  ASSERT_TRUE(run.results.found);
  const std::string text = answered_text(run, ".");
  EXPECT_NE(text.find("# kept"), std::string::npos);
  EXPECT_EQ(text.find("tension: 560 kN"), std::string::npos);
  const Description again = read_model_text(text, "again.yaml").description.value();
  EXPECT_NEAR(again.tensioner.tension.value(), run.results.unknowns[0].answer, 1e-3);
  EXPECT_NEAR(run.statics.results->stations.back().inclination, 65.0 * 3.14159265358979 / 180.0, 1e-7);
}

}  // namespace
}  // namespace overbend
