#include "statics/solver/static_obstacle.h"

#include <gtest/gtest.h>

#include "modelfile/moored_texts.h"
#include "modelfile/reading/yaml_reader.h"

namespace overbend {
namespace {

Description read(const std::string& path) {
  return read_model(OVERBEND_SOURCE_DIR + path).description.value();
}

TEST(static_obstacle, a_pipe_on_a_held_vessel_has_none) {
  EXPECT_FALSE(static_obstacle(read("/examples/bgl1.yaml")));
  EXPECT_FALSE(static_obstacle(read("/examples/first-model.yaml")));
}

TEST(static_obstacle, what_is_not_a_pipe_is_refused_as_input) {
  const Description moored = read_model_text(testing::kMoored, "moored.yaml").description.value();
  const Description lines = read_model_text(testing::kLines, "lines.yaml").description.value();
  for (const Description* d : {&moored, &lines}) {
    const std::optional<StaticFailure> refusal = static_obstacle(*d);
    ASSERT_TRUE(refusal);
    EXPECT_TRUE(refusal->input);
    EXPECT_EQ(refusal->what, "the model has no pipe");
    EXPECT_EQ(pipe_obstacle(*d, "a lay table"), "the model has no pipe for a lay table; give the key pipe");
  }
  EXPECT_FALSE(pipe_obstacle(read("/examples/bgl1.yaml"), "a lay table"));
}

TEST(static_obstacle, nothing_beside_the_pipe_is_passed_over_in_silence) {
  Description d = read("/examples/bgl1-moored.yaml");
  EXPECT_FALSE(static_obstacle(d));
  d.moorings.reset();
  EXPECT_FALSE(static_obstacle(d));
  d.vessel.coupled->ballast = Ballast::as_given;
  ASSERT_TRUE(static_obstacle(d));
  EXPECT_NE(static_obstacle(d)->what.find("sinks and trims"), std::string::npos);
  d.vessel.coupled.reset();
  EXPECT_FALSE(static_obstacle(d));
  d.lines.emplace_back();
  ASSERT_TRUE(static_obstacle(d));
  EXPECT_NE(static_obstacle(d)->what.find("a line beside the pipe"), std::string::npos);
}

}  // namespace
}  // namespace overbend
