// Clumps, buoys and lines on a pipe that is laid: what the reader fills, and what it rejects by name.
#include <gtest/gtest.h>

#include "base/constants.h"
#include "modelfile/reading/yaml_reader.h"
#include "statics/solver/unsupported_statics.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

std::string lay_with(const std::string& before, const std::string& after) {
  std::string text = testing::file_text(OVERBEND_SOURCE_DIR "/examples/buoys-on-pipe.yaml");
  const auto sample = text.find(before);
  EXPECT_NE(sample, std::string::npos) << before;
  return text.replace(sample, before.size(), after);
}

void expect_complaint(const std::string& text, const std::string& key, const std::string& message) {
  const std::vector<std::string> errors = read_model_text(text, "lay.yaml").diagnostics.lines(Severity::error);
  ASSERT_EQ(errors.size(), 1U) << message;
  EXPECT_NE(errors.front().find("lay.yaml:"), std::string::npos) << errors.front();
  EXPECT_NE(errors.front().find(key), std::string::npos) << errors.front();
  EXPECT_NE(errors.front().find(message), std::string::npos) << errors.front();
}

TEST(pipe_attachment_keys, make_mass_and_net_force_of_weight_and_buoyancy) {
  const Description d = *read_model_text(lay_with("arc_length: 150 m", "arc_length: 160 m"), "lay.yaml").description;
  ASSERT_EQ(d.pipe.points.size(), 3U);
  EXPECT_EQ(d.pipe.points[0].at, 160.0);
  EXPECT_NEAR(d.pipe.points[0].mass, 8e3 / kGravity, 1e-9);
  EXPECT_NEAR(d.pipe.points[0].net_force, -6e3, 1e-6);
  EXPECT_NEAR(d.pipe.points[1].net_force, 5e3, 1e-6);
  EXPECT_EQ(d.lines[0].second.line, "pipe");
}

TEST(pipe_attachment_keys, reject_places_that_the_pipe_does_not_have) {
  expect_complaint(lay_with("arc_length: 150 m", "arc_length: 0 m"), "pipe.points[0].arc_length", "more than 0 m");
  expect_complaint(lay_with("{line: pipe, arc_length: 40 m}", "{line: pipe, arc_length: 0 m}"),
                   "lines[0].ends[1].arc_length", "more than 0 m");
  expect_complaint(lay_with("  points:", "  length: 460 m\n  points:"), "pipe.points[2].arc_length",
                   "less than the length of the pipe");
}

TEST(pipe_attachment_keys, reject_a_name_again_and_a_line_that_is_not_there) {
  expect_complaint(lay_with("name: buoy 1", "name: clump"), "pipe.points[1].name", "a unique name");
  expect_complaint(lay_with("{line: pipe, arc_length: 40 m}", "{line: pip, arc_length: 40 m}"), "lines[0].ends[1].line",
                   "did you mean 'pipe'?");
}

TEST(pipe_attachment_keys, reject_a_line_whose_other_end_has_no_place_of_its_own) {
  const std::string end = "{body: vessel, at: {x: -90 m, y: 0 m, z: 9 m}}";
  for (const char* second : {"{free: true}", "{line: pipe, arc_length: 90 m}"}) {
    const Description d = *read_model_text(lay_with(end, second), "lay.yaml").description;
    const std::optional<StaticFailure> failure = unsupported_in_statics(d);
    ASSERT_TRUE(failure) << second;
    EXPECT_TRUE(failure->input);
    EXPECT_EQ(failure->where, "wire");
  }
}

}  // namespace
}  // namespace overbend
