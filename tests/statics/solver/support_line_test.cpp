// Slips of unit and digit in the places of boxes are found before any pipe is laid over them.
#include "statics/solver/support_line.h"

#include <gtest/gtest.h>

#include "modelfile/reading/yaml_reader.h"

namespace overbend {
namespace {

Description first_model() {
  return read_model(OVERBEND_SOURCE_DIR "/examples/first-model.yaml").description.value();
}

std::optional<StaticFailure> judged(const Description& d) {
  const Model model = build_model(d);
  return misplaced_box(model, lay_plane(model, model.mean_pose));
}

TEST(support_line, any_height_given_in_millimetres_is_traced_to_its_box) {
  for (std::size_t i = 0; i < 6; ++i) {
    Description d = first_model();
    d.supports.boxes[i].z *= 1000.0;
    const auto failure = judged(d);
    ASSERT_TRUE(failure.has_value()) << i;
    EXPECT_EQ(failure->where, "box '" + d.supports.boxes[i].name + "'") << failure->why;
    const StaticOutcome outcome = solve_statics(build_model(d));  // at once: a mesh over such a box takes gigabytes
    ASSERT_TRUE(outcome.failure.has_value());
    EXPECT_EQ(outcome.failure->where, failure->where);
  }
}

TEST(support_line, a_box_far_above_its_neighbours_is_traced) {
  for (std::size_t i = 0; i < 6; ++i) {
    Description d = first_model();
    d.supports.boxes[i].z = 45.8;
    const auto failure = judged(d);
    ASSERT_TRUE(failure.has_value()) << i;
    EXPECT_EQ(failure->where, "box '" + d.supports.boxes[i].name + "'") << failure->why;
  }
}

TEST(support_line, a_box_that_merely_stands_proud_is_left_to_the_solution) {
  EXPECT_FALSE(judged(first_model()).has_value());
  for (std::size_t i = 0; i < 6; ++i) {
    Description d = first_model();
    d.supports.boxes[i].z = -d.supports.boxes[i].z;  // the slip of a sign
    EXPECT_FALSE(judged(d).has_value()) << i << judged(d)->why;
    d = first_model();
    d.supports.boxes[i].z -= 3.0;  // lowered out of the way
    EXPECT_FALSE(judged(d).has_value()) << i;
  }
}

TEST(support_line, a_line_without_supports_has_none_misplaced) {
  Description d = first_model();
  d.supports.boxes.clear();
  EXPECT_FALSE(judged(d).has_value());
}

TEST(support_line, a_mesh_beyond_all_memory_is_rejected_before_it_is_built) {
  Description d = first_model();
  d.mesh.overbend_element = 1e-6;
  const StaticFailure f = solve_statics(build_model(d)).failure.value();
  EXPECT_NE(f.what.find("mesh"), std::string::npos);
  d = first_model();
  d.pipe.length = 1e9;
  d.mesh.max_element_length = 1.0;
  EXPECT_NE(solve_statics(build_model(d)).failure.value().what.find("mesh"), std::string::npos);
}

}  // namespace
}  // namespace overbend
