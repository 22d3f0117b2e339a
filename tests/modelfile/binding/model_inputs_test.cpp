#include "modelfile/binding/model_inputs.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "modelfile/reading/yaml_reader.h"

namespace overbend {
namespace {

Description bgl1() {
  return read_model(OVERBEND_SOURCE_DIR "/examples/bgl1.yaml").description.value();
}

TEST(model_inputs, an_input_is_found_by_its_index_and_by_the_name_of_its_item) {
  const ModelValues values(bgl1());
  const auto by_index = values.find("supports.stinger.boxes[2].z");
  ASSERT_TRUE(by_index);
  EXPECT_EQ(values.find("supports.stinger.boxes[stinger 3].z"), by_index);
  EXPECT_EQ(values.inputs()[*by_index].unit, "m");
  EXPECT_FALSE(values.find("supports.stinger.boxes[20].z"));
}

TEST(model_inputs, another_number_is_that_of_a_model_file_with_it) {
  ModelValues values(bgl1());
  const ModelInput& depth = values.inputs().at(values.find("environment.water_depth").value());
  EXPECT_EQ(depth.value, 89.0);
  EXPECT_EQ(values.with(depth, 90.5).environment.water_depth, 90.5);
  EXPECT_EQ(values.with(depth, depth.value).environment.water_depth, 89.0);  // nothing of it is left
  EXPECT_EQ(values.with(depth, 90.5).supports.boxes.size(), bgl1().supports.boxes.size());
}

TEST(model_inputs, what_does_not_move_a_lay_at_rest_is_no_input) {
  const ModelValues values(bgl1());
  for (const ModelInput& input : values.inputs()) {
    EXPECT_FALSE(input.key.starts_with("analysis")) << input.key;
    EXPECT_FALSE(input.key.starts_with("environment.waves")) << input.key;
    EXPECT_NE(input.key, "overbend");
    EXPECT_FALSE(input.key.ends_with(".rows")) << "a counter has no derivative: " << input.key;
  }
}

TEST(model_inputs, what_only_turns_a_stinger_that_is_held_where_it_rests_is_no_input) {
  const ModelValues values(read_model(OVERBEND_SOURCE_DIR "/examples/floating_stinger.yaml").description.value());
  EXPECT_TRUE(values.find("supports.stinger.boxes[2].z"));
  EXPECT_TRUE(values.find("supports.stinger.hinge.z"));
  EXPECT_FALSE(values.find("supports.stinger.body.weight"));
  EXPECT_FALSE(values.find("supports.stinger.tanks[0].ballast"));
  EXPECT_FALSE(values.find("supports.stinger.limits[0]"));
}

}  // namespace
}  // namespace overbend
