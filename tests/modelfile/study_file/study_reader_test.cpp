#include "modelfile/study_file/study_reader.h"

#include <gtest/gtest.h>

#include "app/program.h"
#include "app/small_lay.h"

namespace overbend {
namespace {

using testing::Scratch;

/// A study of the small lay.
StudyReading read_test_study(const std::string& text) {
  const Scratch scratch;
  scratch.write("lay.yaml", testing::kSmallLay);
  scratch.write("seas.csv", "hs_m,5,7\n0.25,10,20\n0.75,5,10\n");
  return read_study_text("overbend_study: 1\nbase: lay.yaml\n" + text, scratch.file("study.yaml"));
}

StudyDescription read_valid_study(const std::string& text) {
  const StudyReading reading = read_test_study(text);
  for (const std::string& line : reading.diagnostics.lines(Severity::error)) ADD_FAILURE() << line;
  return reading.study.value_or(StudyDescription{});
}

/// The one error of a text.
std::string first_study_error(const std::string& text) {
  const std::vector<std::string> lines = read_test_study(text).diagnostics.lines(Severity::error);
  EXPECT_EQ(lines.size(), 1U) << ::testing::PrintToString(lines);
  return lines.empty() ? "" : lines.front();
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(study_reader, ranges_are_given_by_step_or_by_their_number_of_values) {
  const StudyDescription study = read_valid_study(
      "axes:\n"
      "  - {key: environment.waves.from, from: 0 deg, to: 330 deg, step: 30 deg}\n"
      "  - {key: tensioner.tension, from: 200 kN, to: 400 kN, steps: 5}\n"
      "  - {key: environment.water_depth, from: 21 m, to: 20 m, step: 0.1 m}\n");
  ASSERT_EQ(study.axes.size(), 3U);
  ASSERT_EQ(study.axes[0].values.size(), 12U);
  EXPECT_EQ(study.axes[0].values[11], "330 deg");
  EXPECT_EQ(study.axes[1].values, (std::vector<std::string>{"200 kN", "250 kN", "300 kN", "350 kN", "400 kN"}));
  ASSERT_EQ(study.axes[2].values.size(), 11U);
  EXPECT_EQ(study.axes[2].values[3], "20.7 m");
}

TEST(study_reader, names_and_items_of_lists_vary_too) {
  const StudyDescription study = read_valid_study(
      "axes:\n"
      "  - {key: environment.waves.type, values: [jonswap, pierson_moskowitz]}\n"
      "  - {key: \"supports.stinger.boxes[*].z\", values: [-4 m, -5 m], with: environment.waves.type}\n");
  EXPECT_EQ(study.axes[0].values[1], "pierson_moskowitz");
  EXPECT_EQ(study.axes[1].with, "environment.waves.type");
}

TEST(study_reader, an_unknown_key_is_reported_with_its_line_and_the_nearest_one) {
  const std::string line = first_study_error("axes:\n  - {key: tensioner.tensoin, values: [200 kN]}\n");
  EXPECT_TRUE(has(line, "study.yaml:4: axes[0].key")) << line;
  EXPECT_TRUE(has(line, "did you mean 'tensioner.tension'?")) << line;
}

TEST(study_reader, values_are_held_to_unit_and_range_of_the_key) {
  EXPECT_TRUE(
      has(first_study_error("axes:\n  - {key: tensioner.tension, values: [200 kN, 3 m]}\n"), "axes[0].values[1]"));
  EXPECT_TRUE(has(first_study_error("axes:\n  - {key: environment.water_depth, values: [-3 m]}\n"), "above 0 m"));
  EXPECT_TRUE(has(first_study_error("axes:\n  - {key: environment.waves.type, values: [jonswop]}\n"), "jonswap"));
}

TEST(study_reader, items_that_a_list_does_not_have_are_rejected) {
  const std::string line = first_study_error("axes:\n  - {key: \"supports.stinger.boxes[7].z\", values: [-4 m]}\n");
  EXPECT_TRUE(has(line, "an item in the list")) << line;
}

TEST(study_reader, a_list_taken_for_a_group_or_the_reverse_is_named_with_the_key_that_fits) {
  const std::string group = first_study_error("axes: [{key: \"environment.waves[0].hs\", values: [1 m]}]\n");
  EXPECT_TRUE(has(group, "environment.waves without brackets, a group in this model, as in environment.waves.hs"))
      << group;

  const Scratch scratch;
  std::string lay = testing::kSmallLay;
  const std::size_t from = lay.find("waves: {"), to = lay.find('}', from);
  ASSERT_TRUE(from != std::string::npos && to != std::string::npos);
  scratch.write("lay.yaml", lay.insert(to + 1, "]").insert(from + 7, "["));
  const StudyReading reading =
      read_study_text("overbend_study: 1\nbase: lay.yaml\naxes: [{key: environment.waves.hs, values: [1 m]}]\n",
                      scratch.file("study.yaml"));
  ASSERT_EQ(reading.diagnostics.lines(Severity::error).size(), 1U);
  const std::string list = reading.diagnostics.lines(Severity::error).front();
  EXPECT_TRUE(has(list, "environment.waves with an item, a list in this model, as in environment.waves[0].hs")) << list;
}

TEST(study_reader, the_radius_of_listed_boxes_is_no_key_to_vary) {
  for (const char* structure : {"ramp", "stinger"}) {
    const std::string key = std::string("supports.") + structure + ".radius";
    const std::string line = first_study_error("axes:\n  - {key: " + key + ", values: [100 m, 150 m]}\n");
    EXPECT_TRUE(has(line, "study.yaml:4: axes[0].key: found '" + key + "' of listed boxes")) << line;
    EXPECT_TRUE(has(line, "replace the list by a row of boxes")) << line;
  }
}

TEST(study_reader, axes_that_change_together_have_as_many_values) {
  const std::string line = first_study_error(
      "axes:\n"
      "  - {key: tensioner.tension, values: [200 kN, 250 kN]}\n"
      "  - {key: environment.water_depth, values: [20 m, 21 m, 22 m], with: tensioner.tension}\n");
  EXPECT_TRUE(has(line, "found 3 values, expected as many as tensioner.tension has, 2")) << line;
}

TEST(study_reader, axes_that_change_together_in_a_ring_are_rejected) {
  const std::string text =
      "axes:\n"
      "  - {key: tensioner.tension, values: [200 kN], with: environment.water_depth}\n"
      "  - {key: environment.water_depth, values: [20 m], with: tensioner.tension}\n";
  EXPECT_FALSE(read_test_study(text).study);
}

TEST(study_reader, a_key_is_set_once) {
  const std::string line = first_study_error(
      "axes:\n"
      "  - {key: \"supports.stinger.boxes[0].z\", values: [-4 m]}\n"
      "  - {key: \"supports.stinger.boxes[*].z\", values: [-4 m]}\n");
  EXPECT_TRUE(has(line, "which is set twice")) << line;
}

TEST(study_reader, an_absurd_number_of_cases_is_rejected_with_the_arithmetic) {
  const std::string line = first_study_error(
      "axes:\n"
      "  - {key: tensioner.tension, from: 200 kN, to: 400 kN, steps: 2001}\n"
      "  - {key: environment.water_depth, from: 20 m, to: 30 m, steps: 1001}\n");
  EXPECT_TRUE(has(line, "2001 x 1001 = 2003001 cases")) << line;
}

TEST(study_reader, a_sample_knows_the_parameters_of_its_distributions) {
  const StudyDescription study = read_valid_study(
      "sample:\n"
      "  count: 20\n"
      "  keys:\n"
      "    tensioner.tension: {distribution: normal, mean: 300 kN, std: 20 kN, from: 200 kN}\n"
      "    environment.water_depth: {from: 19 m, to: 21 m}\n");
  ASSERT_TRUE(study.sample);
  EXPECT_EQ(study.sample->keys[0].mean, 300e3);
  EXPECT_TRUE(study.sample->keys[0].bounded);
  EXPECT_EQ(study.sample->keys[1].to, 21.0);
  EXPECT_TRUE(
      has(first_study_error("sample: {count: 2, keys: {tensioner.tension: {distribution: normal, mean: 300 kN}}}\n"),
          "sample.keys.tensioner.tension.std"));
  EXPECT_TRUE(
      has(first_study_error("sample: {count: 2, keys: {tensioner.tension: {from: 1 kN, to: 2 kN, mode: 1 kN}}}\n"),
          "no such parameter of a uniform distribution"));
}

TEST(study_reader, results_are_those_of_the_analysis) {
  const std::string axis = "axes: [{key: tensioner.tension, values: [300 kN]}]\n";
  EXPECT_EQ(
      read_valid_study(axis + "gather: [static.top_tension, \"max(static.supports[*].reaction)\"]\n").gather.size(),
      2U);
  const std::string dynamic = "analysis: dynamic\ngather: [dynamic.top_tension.max, dynamic.overbend.max_von_mises]\n";
  EXPECT_EQ(read_valid_study(axis + dynamic).gather.size(), 2U);
  EXPECT_TRUE(has(first_study_error(axis + "gather: [static.top_tensoin]\n"), "did you mean 'static.top_tension'?"));
  EXPECT_EQ(read_valid_study(axis + "gather: ['lines[pipe].static.top_tension', 'max(supports[*].static.reaction)']\n")
                .gather.size(),
            2U);
  EXPECT_TRUE(has(first_study_error(axis + "gather: ['lines[pipe].static.top_tensoin']\n"),
                  "did you mean 'lines[pipe].static.top_tension'?"));
  EXPECT_TRUE(has(first_study_error(axis + "gather: ['lines[pipe].dynamic.top_tension.max']\n"), "static analysis"));
  EXPECT_TRUE(has(first_study_error(axis + "gather: [dynamic.top_tension.max]\n"), "static analysis"));
}

TEST(study_reader, a_goal_seek_of_several_keys_has_no_single_slope) {
  const Scratch scratch;
  const auto error = [&](const std::string& vary) {
    scratch.write("lay.yaml", testing::kSmallLay + "seek:\n  vary: " + vary +
                                  "\n  until: {result: static.bottom_tension, equals: 270 kN}\n");
    const StudyReading reading = read_study_text(
        "overbend_study: 1\nbase: lay.yaml\nanalysis: seek\n"
        "axes: [{key: environment.water_depth, values: [19 m, 20 m]}]\n"
        "gather: [seek.slope, seek.residual, seek.evaluations]\n",
        scratch.file("study.yaml"));
    const std::vector<std::string> lines = reading.diagnostics.lines(Severity::error);
    return lines.empty() ? std::string() : lines.front();
  };
  const std::string tension = "{key: tensioner.tension, from: 250 kN, to: 400 kN}";
  EXPECT_EQ(error(tension), "");
  EXPECT_TRUE(has(error("[" + tension + ", {key: environment.seabed.friction, from: 0.1, to: 0.5}]"),
                  "a slope is defined for a single key only"));
}

TEST(study_reader, seeds_are_a_number_or_a_list) {
  EXPECT_EQ(read_valid_study("analysis: dynamic\nseeds: 3\n").seeds, (std::vector<std::uint64_t>{1, 2, 3}));
  EXPECT_EQ(read_valid_study("analysis: dynamic\nseeds: [7, 9]\n").seeds, (std::vector<std::uint64_t>{7, 9}));
  EXPECT_TRUE(
      has(first_study_error("axes: [{key: tensioner.tension, values: [300 kN]}]\nseeds: 3\n"), "analysis: dynamic"));
}

TEST(study_reader, operability_reads_its_criterion_and_resolution) {
  const StudyDescription study = read_valid_study(
      "analysis: dynamic\n"
      "axes: [{key: environment.waves.hs, values: [0.5 m, 3 m]}]\n"
      "operability:\n"
      "  resolution: 50 cm\n"
      "  criterion: [checks, {result: dynamic.top_tension.max, at_most: 500 kN}]\n"
      "  scatter: seas.csv\n"
      "  alpha: 0.8\n");
  ASSERT_TRUE(study.operability);
  EXPECT_EQ(study.operability->resolution, 0.5);
  EXPECT_TRUE(study.operability->checks);
  ASSERT_EQ(study.operability->criterion.size(), 1U);
  EXPECT_EQ(study.operability->criterion[0].value, 500e3);
  EXPECT_TRUE(study.operability->scatter_file.ends_with("seas.csv"));
  ASSERT_TRUE(study.operability->scatter);
  EXPECT_EQ(study.operability->scatter->seas.size(), 4U);
  EXPECT_TRUE(has(first_study_error("analysis: dynamic\naxes: [{key: environment.waves.tp, values: [6 s, 8 s]}]\n"
                                    "operability: {over: environment.waves.hs}\n"),
                  "the key of an axis"));
}

TEST(study_reader, mean_periods_of_a_scatter_diagram_become_peak_periods_of_the_base_model) {
  const std::string text =
      "analysis: dynamic\naxes: [{key: environment.waves.hs, values: [0.5 m, 3 m]}]\n"
      "operability: {scatter: seas.csv, scatter_period: tz}\n";
  const StudyDescription study = read_valid_study(text);
  ASSERT_TRUE(study.operability && study.operability->scatter);
  EXPECT_GT(study.operability->scatter->seas[0].tp, 1.2 * 5.0);
  EXPECT_NE(study.operability->scatter->remark.find("Tz"), std::string::npos);
}

TEST(study_reader, limits_are_found_to_a_quarter_metre_or_a_hundredth_of_the_range) {
  EXPECT_EQ(read_valid_study("axes: [{key: environment.water_depth, values: [15 m, 30 m]}]\n"
                             "operability: {over: environment.water_depth}\n")
                .operability->resolution,
            0.25);
  EXPECT_DOUBLE_EQ(read_valid_study("axes: [{key: tensioner.tension, values: [40 kN, 60 kN, 50 kN]}]\n"
                                    "operability: {over: tensioner.tension}\n")
                       .operability->resolution,
                   200.0);
}

TEST(study_reader, errors_of_the_base_model_are_reported_at_its_own_lines) {
  const Scratch scratch;
  scratch.write("lay.yaml", testing::with(testing::kSmallLay, "water_depth: 20 m", "water_depth: 20"));
  const StudyReading reading =
      read_study_text("overbend_study: 1\nbase: lay.yaml\nseeds: 2\n", scratch.file("study.yaml"));
  EXPECT_FALSE(reading.study);
  EXPECT_TRUE(has(reading.diagnostics.lines(Severity::error).at(0), "lay.yaml:4: environment.water_depth"));
}

}  // namespace
}  // namespace overbend
