#include "base/result_path.h"

#include <gtest/gtest.h>

namespace overbend {
namespace {

TEST(split_result_path, splits_at_points_and_brackets_and_joins_again) {
  for (const char* name : {"a", "a.b", "supports.stinger.boxes[stinger 3.5].z", "a[0][1].b", "static.supports[*].x"}) {
    const auto parts = split_result_path(name);
    ASSERT_TRUE(parts) << name;
    EXPECT_EQ(join_result_path(*parts), name);
  }
  const auto parts = split_result_path("boxes[stinger 3.5].z").value();
  ASSERT_EQ(parts.size(), 3U);
  EXPECT_EQ(parts[1].text, "stinger 3.5");
  EXPECT_TRUE(parts[1].item);
  EXPECT_FALSE(parts[2].item);
}

TEST(split_result_path, rejects_what_is_no_name) {
  for (const char* name : {"", ".a", "a.", "a..b", "[0]", "a[", "a[]", "a.[0]", "a[0]b"}) {
    EXPECT_FALSE(split_result_path(name)) << name;
  }
}

TEST(split_result_path, distinguishes_an_index_from_a_name) {
  EXPECT_EQ(item_index("12"), 12U);
  EXPECT_FALSE(item_index("stinger 3"));
  EXPECT_FALSE(item_index("-1"));
}

TEST(split_result_path, a_star_stands_for_any_letters) {
  EXPECT_TRUE(matches_pattern("*", "ramp 1"));
  EXPECT_TRUE(matches_pattern("stinger *", "stinger 7"));
  EXPECT_TRUE(matches_pattern("*ing*", "stinger 7"));
  EXPECT_FALSE(matches_pattern("stinger *", "ramp 1"));
  EXPECT_FALSE(matches_pattern("stinger", "stinger 7"));
}

TEST(split_result_path, many_stars_take_no_more_time_than_one) {
  const std::string stars(2000, '*'), letters(2000, 'a');
  EXPECT_TRUE(matches_pattern(stars, letters));
  EXPECT_TRUE(matches_pattern("*a*a*a*a*a*a*a*a*a*a*", letters));
  EXPECT_FALSE(matches_pattern("*a*a*a*a*a*a*a*a*a*a*b", letters));
  EXPECT_FALSE(matches_pattern(stars + "b", letters));
  EXPECT_TRUE(matches_pattern("a*b*", "axxbxb"));
  EXPECT_FALSE(matches_pattern("a*b", "axxbxbc"));
}

TEST(split_result_path, no_name_has_more_parts_than_any_key) {
  std::string name = "a";
  for (int i = 0; i < 63; ++i) name += ".a";
  EXPECT_TRUE(split_result_path(name));
  EXPECT_FALSE(split_result_path(name + ".a"));
  EXPECT_FALSE(split_result_path(std::string(5000, 'a')));
}

TEST(split_result_path, an_item_is_chosen_by_index_range_name_or_pattern) {
  EXPECT_TRUE(chooses_item("3", 3, "ramp 4"));
  EXPECT_FALSE(chooses_item("3", 2, "3"));
  EXPECT_TRUE(chooses_item("0..4", 4, "ramp 5"));
  EXPECT_FALSE(chooses_item("0..4", 5, "ramp 6"));
  EXPECT_TRUE(chooses_item("ramp 4", 3, "ramp 4"));
  EXPECT_TRUE(chooses_item("ramp *", 3, "ramp 4"));
}

}  // namespace
}  // namespace overbend
