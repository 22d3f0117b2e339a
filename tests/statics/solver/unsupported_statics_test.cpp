#include "statics/solver/unsupported_statics.h"

#include <gtest/gtest.h>

#include "modelfile/moored_texts.h"
#include "modelfile/reading/yaml_reader.h"

namespace overbend {
namespace {

Description read(const std::string& path) {
  return read_model(OVERBEND_SOURCE_DIR + path).description.value();
}

TEST(unsupported_in_statics, a_pipe_on_a_held_vessel_has_none) {
  EXPECT_FALSE(unsupported_in_statics(read("/examples/bgl1.yaml")));
  EXPECT_FALSE(unsupported_in_statics(read("/examples/first-model.yaml")));
}

TEST(unsupported_in_statics, what_is_not_a_pipe_is_rejected_as_input) {
  const Description moored = read_model_text(testing::kMoored, "moored.yaml").description.value();
  const Description lines = read_model_text(testing::kLines, "lines.yaml").description.value();
  for (const Description* d : {&moored, &lines}) {
    const std::optional<StaticFailure> rejection = unsupported_in_statics(*d);
    ASSERT_TRUE(rejection);
    EXPECT_TRUE(rejection->input);
    EXPECT_EQ(rejection->what, "the model has no pipe");
    EXPECT_EQ(missing_pipe_message(*d, "a lay table"), "the model has no pipe for a lay table; give the key pipe");
  }
  EXPECT_FALSE(missing_pipe_message(read("/examples/bgl1.yaml"), "a lay table"));
}

TEST(unsupported_in_statics, nothing_next_to_the_pipe_is_passed_over_in_silence) {
  Description d = read("/examples/bgl1-moored.yaml");
  EXPECT_FALSE(unsupported_in_statics(d));
  d.moorings.reset();
  EXPECT_FALSE(unsupported_in_statics(d));
  d.vessel.coupled->ballast = Ballast::as_given;
  ASSERT_TRUE(unsupported_in_statics(d));
  EXPECT_NE(unsupported_in_statics(d)->what.find("sinks and trims"), std::string::npos);
  d.vessel.coupled.reset();
  EXPECT_FALSE(unsupported_in_statics(d));
  d.lines.emplace_back();
  ASSERT_TRUE(unsupported_in_statics(d));
  EXPECT_NE(unsupported_in_statics(d)->what.find("a line that is not attached to the pipe"), std::string::npos);
}

}  // namespace
}  // namespace overbend
