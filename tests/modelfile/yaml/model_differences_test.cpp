#include "modelfile/yaml/model_differences.h"

#include <gtest/gtest.h>

namespace overbend {
namespace {

std::vector<DifferingKey> between(const std::string& a, const std::string& b) {
  const std::vector<std::string> texts = {a, b};
  return differing_keys(texts);
}

TEST(model_differences, equal_quantities_in_other_units_are_no_difference) {
  EXPECT_TRUE(between("pipe: {diameter: 1 m, length: 0.5 km}", "pipe: {diameter: 1000 mm, length: 500.0 m}").empty());
  EXPECT_TRUE(same_quantity("406.4 mm", "16 inch"));
  EXPECT_TRUE(same_quantity("1", "1.0"));
  EXPECT_TRUE(same_quantity("180 deg", "3.141592653589793 rad"));
  EXPECT_FALSE(same_quantity("1 m", "1 s"));
  EXPECT_FALSE(same_quantity("1 m", "1.000001 m"));
  EXPECT_FALSE(same_quantity("1 m", "1"));
  EXPECT_FALSE(same_quantity("rollers", "gap_springs"));
}

TEST(model_differences, a_key_that_only_one_has_is_listed) {
  const std::vector<DifferingKey> keys = between("a: {b: 1, c: 2}", "a: {b: 1}");
  ASSERT_EQ(keys.size(), 1u);
  EXPECT_EQ(keys[0].key, "a.c");
  EXPECT_EQ(keys[0].values, (std::vector<std::string>{"2", ""}));
}

TEST(model_differences, items_with_names_are_compared_by_name_and_not_by_place) {
  const std::vector<DifferingKey> keys =
      between("boxes: [{name: a, x: 1 m}, {name: b, x: 2 m}]", "boxes: [{name: b, x: 2 m}, {name: a, x: 3 m}]");
  ASSERT_EQ(keys.size(), 1u);
  EXPECT_EQ(keys[0].key, "boxes[a].x");
}

TEST(model_differences, items_without_names_are_compared_by_their_index) {
  const std::vector<DifferingKey> keys =
      between("current: [{speed: 1 m/s}, {speed: 2 m/s}]", "current: [{speed: 1 m/s}]");
  ASSERT_EQ(keys.size(), 1u);
  EXPECT_EQ(keys[0].key, "current[1].speed");
}

TEST(model_differences, comments_order_and_quotes_are_no_difference) {
  EXPECT_TRUE(between("a: 1  # one\nb: 'two'\n", "b: two\na: 1\n").empty());
}

TEST(model_differences, three_models_are_compared_at_once) {
  const std::vector<std::string> texts = {"a: 1", "a: 1", "a: 2"};
  const std::vector<DifferingKey> keys = differing_keys(texts);
  ASSERT_EQ(keys.size(), 1u);
  EXPECT_EQ(keys[0].values, (std::vector<std::string>{"1", "1", "2"}));
}

}  // namespace
}  // namespace overbend
