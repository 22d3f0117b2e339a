// Keys of a goal seek: what they fill, and what the reader rejects.
#include <gtest/gtest.h>

#include <algorithm>

#include "modelfile/model_texts.h"
#include "modelfile/reading/seek_reader.h"
#include "modelfile/reading/yaml_reader.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

ModelReading with_seek(const std::string& seek) {
  return read_model_text(testing::kGoodModel + "\nseek:\n" + seek, "seek.yaml");
}

SeekDescription read_seek_text(const std::string& text) {
  const ModelReading reading = with_seek(text);
  for (const std::string& line : reading.diagnostics.lines(Severity::error)) ADD_FAILURE() << line;
  return reading.description ? read_seek(*reading.description).value_or(SeekDescription{}) : SeekDescription{};
}

/// The one complaint about a seek.
std::string complaint(const std::string& seek) {
  const std::vector<std::string> errors = with_seek(seek).diagnostics.lines(Severity::error);
  EXPECT_EQ(errors.size(), 1U) << seek;
  return errors.empty() ? "" : errors.front();
}

void expect_arguments(const std::string& text, const std::vector<std::string>& arguments) {
  for (const std::string& word : arguments) EXPECT_NE(text.find(word), std::string::npos) << word << " in: " << text;
}

TEST(seek_keys, fill_bounds_and_conditions_in_si) {
  const SeekDescription seek = read_seek_text(
      "  vary: {key: tensioner.tension, from: 150 kN, to: 600 kN}\n"
      "  until: {result: static.sagbend.max_bending_stress, equals: 100 MPa}\n");
  ASSERT_EQ(seek.vary.size(), 1U);
  EXPECT_EQ(seek.vary[0].from, 150e3);
  EXPECT_EQ(seek.vary[0].to, 600e3);
  EXPECT_EQ(seek.vary[0].show, "kN");
  ASSERT_EQ(seek.until.size(), 1U);
  EXPECT_EQ(seek.until[0].relation, SeekRelation::equals);
  EXPECT_EQ(seek.until[0].value, 100e6);
}

TEST(seek_keys, take_results_by_object) {
  const SeekDescription seek = read_seek_text(
      "  vary: {key: tensioner.tension, from: 150 kN, to: 600 kN}\n"
      "  until: {result: 'lines[pipe].static.sagbend.max_bending_stress', at_most: 100 MPa}\n"
      "  minimise: 'spread(supports[*].static.reaction)'\n");
  ASSERT_EQ(seek.until.size(), 1U);
  EXPECT_EQ(seek.until[0].value, 100e6);
  EXPECT_EQ(seek.minimise, "spread(supports[*].static.reaction)");
}

TEST(seek_keys, do_not_take_the_radius_of_listed_boxes) {
  const std::string line = complaint(
      "  vary: {key: supports.stinger.radius, from: 100 m, to: 200 m}\n"
      "  until: {result: static.lay_back, equals: 200 m}\n");
  expect_arguments(line,
                   {"seek.vary", "supports.stinger.radius' of listed boxes", "replace the list by a row of boxes"});
}

TEST(seek_keys, take_lists_patterns_plain_numbers_and_something_to_minimise) {
  const SeekDescription seek = read_seek_text(
      "  vary:\n"
      "    - {key: 'supports.stinger.boxes[*].z', within: 300 mm}\n"
      "    - {key: environment.seabed.friction, from: 0.1, to: 1}\n"
      "  until:\n"
      "    - {result: static.stinger_tip_clearance, at_least: 0.3 m}\n"
      "    - {result: static.overbend.max_strain, at_most: 0.2 %}\n"
      "  minimise: spread(static.supports[*].reaction)\n");
  ASSERT_EQ(seek.vary.size(), 2U);
  EXPECT_EQ(seek.vary[0].within, 0.3);
  EXPECT_FALSE(seek.vary[0].from);
  EXPECT_EQ(seek.vary[1].from, 0.1);
  ASSERT_EQ(seek.until.size(), 2U);
  EXPECT_EQ(seek.until[0].relation, SeekRelation::at_least);
  EXPECT_NEAR(seek.until[1].value, 0.002, 1e-15);
  EXPECT_EQ(seek.minimise, "spread(static.supports[*].reaction)");
}

TEST(seek_keys, a_key_has_to_be_a_number_of_the_model) {
  const std::string until = "  until: {result: static.lay_back, equals: 300 m}\n";
  expect_arguments(complaint("  vary: {key: tensioner.tention, from: 1 kN, to: 2 kN}\n" + until),
                   {"seek.yaml:", "seek.vary.key", "tensioner.tention", "tensioner.tension"});
  expect_arguments(complaint("  vary: {key: vessel.name, from: 1 kN, to: 2 kN}\n" + until),
                   {"seek.vary.key", "vessel.name"});
  expect_arguments(complaint("  vary: {key: 'supports.stinger.boxes[unknown].z', within: 1 m}\n" + until),
                   {"seek.vary.key", "unknown", "an item in the list"});
}

TEST(seek_keys, may_be_those_of_lines_by_themselves) {
  const std::string lines = testing::file_text(OVERBEND_SOURCE_DIR "/examples/jumper.yaml");
  for (const char* result : {"static.lines[0].first.tension", "lines[jumper].static.first.tension"}) {
    const ModelReading reading = read_model_text(
        lines + "\nseek:\n  vary: {key: 'lines[0].segments[0].length', from: 165 m, to: 180 m}\n  until: {result: '" +
            result + "', equals: 25 kN}\n",
        OVERBEND_SOURCE_DIR "/examples/sought.yaml");
    EXPECT_TRUE(reading.diagnostics.lines(Severity::error).empty()) << result;
  }
}

/// No result used by a goal seek depends on them.
TEST(seek_keys, a_key_of_the_operation_is_none_to_vary) {
  expect_arguments(complaint("  vary: {key: operation.head.weight_submerged, from: 5 kN, to: 30 kN}\n"
                             "  until: {result: static.lay_back, equals: 300 m}\n"),
                   {"seek.vary.key", "a goal seek evaluates the normal lay configuration"});
}

TEST(seek_keys, bounds_have_the_dimension_and_the_range_of_their_key) {
  const std::string until = "  until: {result: static.lay_back, equals: 300 m}\n";
  expect_arguments(complaint("  vary: {key: tensioner.tension, from: 1 m, to: 600 kN}\n" + until),
                   {"seek.vary.from", "a length", "a force"});
  expect_arguments(complaint("  vary: {key: environment.water_depth, from: -5 m, to: 60 m}\n" + until),
                   {"seek.vary.from", "-5 m"});
  expect_arguments(complaint("  vary: {key: tensioner.tension, from: 600 kN, to: 150 kN}\n" + until),
                   {"seek.vary.to", "more than the lower bound"});
  expect_arguments(complaint("  vary: {key: tensioner.tension, from: 600 kN}\n" + until),
                   {"seek.vary", "from and to, or within"});
  expect_arguments(complaint("  vary: {key: tensioner.tension, from: 1 kN, to: 2 kN, within: 3 kN}\n" + until),
                   {"bounds given twice"});
}

TEST(seek_keys, a_result_has_to_be_one_and_its_value_of_its_dimension) {
  const std::string vary = "  vary: {key: tensioner.tension, from: 150 kN, to: 600 kN}\n";
  expect_arguments(complaint(vary + "  until: {result: static.sagbend.max_bending_stres, equals: 100 MPa}\n"),
                   {"seek.until.result", "did you mean 'static.sagbend.max_bending_stress'?"});
  expect_arguments(
      complaint(vary + "  until: {result: 'lines[pipe].static.sagbend.max_bending_stres', equals: 1 MPa}\n"),
      {"seek.until.result", "did you mean 'lines[pipe].static.sagbend.max_bending_stress'?"});
  expect_arguments(complaint(vary + "  until: {result: 'stages[2].lines[pipe].static.lay_back', equals: 1 m}\n"),
                   {"seek.until.result", "not the stages"});
  expect_arguments(complaint(vary + "  until: {result: static.lay_back, equals: 100 MPa}\n"),
                   {"seek.until.equals", "a force per area", "a length"});
  expect_arguments(complaint(vary + "  until: {result: static.lay_back}\n"), {"one of equals, at_most or at_least"});
  expect_arguments(complaint(vary + "  until: {result: static.lay_back, equals: 1 m, at_most: 2 m}\n"),
                   {"several values for the result"});
  expect_arguments(complaint(vary), {"seek.until", "a condition on a result"});
  expect_arguments(
      complaint(vary + "  until: {result: 'operation.stages[A].sagbend.max_strain', at_most: 0.2 %}\n"),
      {"seek.until.result", "a goal seek evaluates the normal lay configuration, not the stages of its operation"});
  expect_arguments(complaint(vary + "  minimise: static.lay_bak\n"), {"seek.minimise", "static.lay_back"});
}

/// A lift of the examples with another goal seek.
ModelReading lift_with_seek(const std::string& seek) {
  const std::string text = testing::file_text(OVERBEND_SOURCE_DIR "/examples/davit-level.yaml");
  return read_model_text(text.substr(0, text.find("\nseek:")) + "\nseek:\n" + seek, "lift.yaml");
}

std::string lift_complaint(const std::string& seek) {
  const std::vector<std::string> errors = lift_with_seek(seek).diagnostics.lines(Severity::error);
  EXPECT_EQ(errors.size(), 1U) << seek;
  return errors.empty() ? "" : errors.front();
}

TEST(seek_keys, of_a_lift_are_entries_of_stages_by_index_name_or_pattern) {
  for (const char* key : {"operation.stages[3].lengths.davit 1", "operation.stages[level].lengths[davit 2]",
                          "operation.stages[level].lengths[davit *]", "operation.stages[half way].vessel.x",
                          "environment.water_depth", "operation.stages[vessel moved].lengths.davit 3"}) {
    const ModelReading reading = lift_with_seek(
        std::string("  vary: {key: '") + key +
        "', from: 3 m, to: 20 m}\n  until: {result: 'operation.stages[level].lines[pipe].first_end.z', equals: 2 m}\n");
    EXPECT_TRUE(reading.diagnostics.lines(Severity::error).empty()) << key;
    const SeekDescription seek = read_seek(reading.description.value()).value();
    EXPECT_EQ(seek.vary.front().unit, "m");
    EXPECT_EQ(seek.until.front().unit, "m");
  }
}

TEST(seek_keys, of_a_lift_name_what_its_stages_have) {
  const std::string vary = "  vary: {key: 'operation.stages[level].lengths.davit 1', from: 3 m, to: 20 m}\n";
  const std::string until = "  until: {result: 'operation.stages[level].lines.pipe.first_end.z', equals: 2 m}\n";
  expect_arguments(
      lift_complaint("  vary: {key: 'operation.stages[levl].lengths.davit 1', from: 3 m, to: 20 m}\n" + until),
      {"seek.vary.key", "picked up, half way, vessel moved and level"});
  expect_arguments(
      lift_complaint("  vary: {key: 'operation.stages[level].lengths[winch *]', from: 3 m, to: 20 m}\n" + until),
      {"seek.vary.key", "davit 1, davit 2 and davit 3"});
  expect_arguments(
      lift_complaint(vary + "  until: {result: 'operation.stages[levl].lines.pipe.first_end.z', equals: 2 m}\n"),
      {"seek.until.result", "there is no 'levl'", "picked up, half way, vessel moved and level"});
  expect_arguments(
      lift_complaint(vary + "  until: {result: 'operation.stages[level].davits.davit 9.length', equals: 2 m}\n"),
      {"seek.until.result", "there is no 'davit 9'", "davit 3"});
  expect_arguments(lift_complaint(vary + "  until: {result: static.lay_back, equals: 2 m}\n"),
                   {"seek.until.result", "a result of a stage of the operation"});
  expect_arguments(
      lift_complaint(vary + "  until: {result: 'operation.stages[level].lines.pipe.first_end.w', equals: 2 m}\n"),
      {"seek.until.result", "did you mean 'operation.stages[].lines[].first_end."});
  expect_arguments(
      lift_complaint(vary + "  until: {result: 'operation.stages[level].lines.pipe.first_end.z', equals: 2 kN}\n"),
      {"seek.until.equals", "a force", "a length"});
}

TEST(seek_keys, of_a_pull_name_results_of_its_stages) {
  const std::string text = testing::file_text(OVERBEND_SOURCE_DIR "/examples/shore-pull.yaml");
  const auto errors = [&](const std::string& result) {
    return read_model_text(
               text + "\nseek:\n  vary: {key: operation.winch.depth, from: -5 m, to: 5 m}\n  until: {result: '" +
                   result + "', at_most: 600 kN}\n",
               "pull.yaml")
        .diagnostics.lines(Severity::error);
  };
  EXPECT_TRUE(errors("operation.stages[10].tension.winch").empty());
  EXPECT_TRUE(errors("max(operation.stages[*].wire_largest_tension)").empty());
  ASSERT_EQ(errors("static.top_tension").size(), 1U);
  expect_arguments(errors("static.top_tension").front(),
                   {"seek.until.result", "operation.stages[0].tension.winch of a pull"});
}

}  // namespace
}  // namespace overbend
