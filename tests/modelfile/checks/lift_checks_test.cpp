// Lines that hold each other and stages of a lift: what the reader rejects, by name.
#include <gtest/gtest.h>

#include "modelfile/reading/yaml_reader.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

std::string lift_with(const std::string& before, const std::string& after) {
  std::string text = testing::file_text(OVERBEND_SOURCE_DIR "/validation/lift_cases/TI12-closed.yaml");
  const auto sample = text.find(before);
  EXPECT_NE(sample, std::string::npos) << before;
  return text.replace(sample, before.size(), after);
}

/// The one complaint, which names the line, the key and what is wrong.
void expect_complaint(const std::string& text, const std::string& key, const std::string& message) {
  const std::vector<std::string> errors = read_model_text(text, "lift.yaml").diagnostics.lines(Severity::error);
  ASSERT_EQ(errors.size(), 1U) << message;
  EXPECT_NE(errors.front().find("lift.yaml:"), std::string::npos) << errors.front();
  EXPECT_NE(errors.front().find(key), std::string::npos) << errors.front();
  EXPECT_NE(errors.front().find(message), std::string::npos) << errors.front();
}

TEST(lift_keys, fill_ends_on_lines_and_stages) {
  const Description d = *read_model_text(lift_with("kink: 0 deg", "kink: 3 deg"), "lift.yaml").description;
  EXPECT_EQ(d.lines[0].first.kind, LineEndKind::free);
  ASSERT_TRUE(d.lines[0].segments[0].section);
  EXPECT_GT(d.lines[0].segments[0].type.bending_stiffness, 1e6);
  EXPECT_EQ(d.lines[2].second.line, "pipe A");
  EXPECT_EQ(d.lines[2].second.arc_length, 6.0);
  EXPECT_EQ(d.operation.type, OperationType::lift);
  const LayStageDescription& welded = d.operation.lay.stages.at(2);
  EXPECT_EQ(welded.join->second, "pipe B");
  EXPECT_NEAR(welded.join->kink, 0.0523598775598, 1e-12);
  EXPECT_EQ(d.operation.lay.stages[0].lengths.size(), 4U);
}

TEST(lift_keys, reject_an_attachment_beyond_the_line) {
  expect_complaint(lift_with("{line: pipe A, arc_length: 6 m}", "{line: pipe A, arc_length: 600 m}"), "arc_length",
                   "at most the length of 'pipe A'");
}

TEST(lift_keys, reject_an_attachment_where_the_end_is_held) {
  expect_complaint(lift_with("{line: pipe A, arc_length: 6 m}", "{line: pipe A, arc_length: 301.185 m}"), "arc_length",
                   "which is the held end of that line");
}

TEST(lift_keys, reject_a_line_on_itself_and_lines_in_a_ring) {
  expect_complaint(lift_with("{line: pipe A, arc_length: 6 m}", "{line: davit 1, arc_length: 6 m}"), "line",
                   "the line itself");
}

TEST(lift_keys, reject_a_line_on_a_straight_wire) {
  expect_complaint(lift_with("{line: pipe B, arc_length: 6 m}", "{line: davit 1, arc_length: 6 m}"), "line",
                   "a straight wire without weight");
}

TEST(lift_keys, reject_two_free_ends_without_a_start) {
  std::string text = lift_with("- bed: {x: -300 m, y: 16 m}\n        direction: {x: -1}", "- free: true");
  expect_complaint(text, "start", "both its ends are free");
}

TEST(lift_keys, reject_stages_that_name_what_is_not_there) {
  expect_complaint(lift_with("lengths: {davit 1: 7.5 m", "lengths: {davit 7: 7.5 m"), "davit 7", "davit 1");
  expect_complaint(lift_with("lengths: {davit 1: 7.5 m", "lengths: {pipe A: 7.5 m"), "pipe A", "pipe");
  expect_complaint(lift_with("lines: [pipe A, pipe B]", "lines: [pipe A, pipe C]"), "pipe C", "pipe B");
  expect_complaint(lift_with("lines: [pipe A, pipe B]", "lines: [pipe A, davit 1]"), "davit 1", "steel");
  expect_complaint(lift_with("lines: [pipe A, pipe B]", "lines: [pipe A]"), "join", "two lines");
}

TEST(lift_keys, reject_a_length_and_a_tension_of_one_line) {
  expect_complaint(lift_with("lengths: {davit 1: 7.5 m", "tensions: {davit 1: 5 kN}, lengths: {davit 1: 7.5 m"),
                   "davit 1", "one of them");
}

TEST(lift_keys, reject_welds_of_pipes_of_two_diameters) {
  expect_complaint(lift_with("outside_diameter: 0.3239 m", "outside_diameter: 0.508 m"), "join",
                   "one outside diameter");
}

TEST(lift_keys, reject_welds_of_what_does_not_begin_with_pipe) {
  expect_complaint(lift_with("    segments:\n      - length: 301.185 m",
                             "    segments:\n      - {length: 20 m, type: davit wire}\n      - length: 301.185 m"),
                   "join", "first segment of 'pipe A'");
}

TEST(lift_keys, reject_welds_where_another_line_is_attached) {
  expect_complaint(lift_with("{line: pipe A, arc_length: 6 m}", "{line: pipe A, arc_length: 0 m}"), "join",
                   "'davit 1' is attached");
}

}  // namespace
}  // namespace overbend
