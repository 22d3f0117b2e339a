#include "modelfile/yaml/yaml_path.h"

#include <gtest/gtest.h>

namespace overbend {
namespace {

YamlNode parsed(const std::string& text) {
  Diagnostics diagnostics;
  return parse_yaml(text, "a.yaml", diagnostics).value();
}

TEST(yaml_path, leads_through_groups_and_lists) {
  const YamlNode root = parsed("a: {list: [{x: 1}, {x: 2}]}\n");
  std::string rest;
  const std::vector<YamlSpot> spots = follow_path(root, "a.list[1].x", rest);
  EXPECT_EQ(rest, "");
  ASSERT_EQ(spots.size(), 5U);
  EXPECT_EQ(spots.back().node->text, "2");
  EXPECT_EQ(spots[3].index, 1U);
  EXPECT_EQ(spots[1].parent, &root);
}

TEST(yaml_path, leaves_over_what_is_not_there) {
  const YamlNode root = parsed("a: {list: [1]}\n");
  std::string rest;
  EXPECT_EQ(follow_path(root, "a.b.c", rest).size(), 2U);
  EXPECT_EQ(rest, "b.c");
  EXPECT_EQ(follow_path(root, "a.list[1]", rest).size(), 3U);
  EXPECT_EQ(rest, "[1]");
  follow_path(root, "a.list.x", rest);
  EXPECT_EQ(rest, "x");
}

// Names of rollers are the user's own and may hold points.
TEST(yaml_path, takes_the_longest_key_that_fits) {
  const YamlNode root = parsed("rollers: {v: {x: 1}, v.2: {x: 2}}\n");
  std::string rest;
  EXPECT_EQ(follow_path(root, "rollers.v.2.x", rest).back().node->text, "2");
  EXPECT_EQ(follow_path(root, "rollers.v.x", rest).back().node->text, "1");
  EXPECT_EQ(rest, "");
}

TEST(yaml_path, falls_into_parts) {
  EXPECT_EQ(path_parts("a.b[0].c"), (std::vector<std::string>{"a", "b", "[0]", "c"}));
  EXPECT_EQ(path_parts("a[0][12]"), (std::vector<std::string>{"a", "[0]", "[12]"}));
  EXPECT_TRUE(path_parts("").empty());
}

TEST(yaml_path, an_index_is_a_whole_number_in_brackets) {
  EXPECT_EQ(leading_index("[12].x"), (std::pair<std::size_t, std::size_t>(12, 4)));
  for (const char* text : {"", "x", "[", "[]", "[a]", "[-1]", "[1", "[1x]", "x[1]"}) {
    EXPECT_FALSE(leading_index(text)) << text;
  }
}

}  // namespace
}  // namespace overbend
