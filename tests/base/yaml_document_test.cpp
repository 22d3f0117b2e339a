#include "base/yaml_document.h"

#include <gtest/gtest.h>

namespace overbend {
namespace {

struct Parsed {
  std::optional<YamlNode> root;
  Diagnostics diagnostics;
};

Parsed parse(const std::string& text) {
  Parsed parsed;
  parsed.root = parse_yaml(text, "a.yaml", parsed.diagnostics);
  return parsed;
}

std::string first_error(const std::string& text) {
  const std::vector<std::string> lines = parse(text).diagnostics.lines(Severity::error);
  return lines.empty() ? "" : lines.front();
}

TEST(yaml_document, remembers_where_everything_is) {
  const Parsed parsed = parse("a: 1\ngroup:\n  list:\n    - x\n    - {deep: y}\n");
  ASSERT_TRUE(parsed.root);
  const YamlEntry& group = parsed.root->entries.at(1);
  EXPECT_EQ(group.key, "group");
  EXPECT_EQ(group.line, 2);
  EXPECT_EQ(group.column, 1);
  const YamlNode& list = group.value.entries.at(0).value;
  ASSERT_EQ(list.items.size(), 2U);
  EXPECT_EQ(list.items[0].line, 4);
  EXPECT_EQ(list.items[0].column, 7);
  EXPECT_EQ(list.items[1].entries.at(0).key, "deep");
  EXPECT_EQ(list.items[1].entries.at(0).value.text, "y");
}

TEST(yaml_document, keeps_texts_as_written_and_knows_quotes) {
  const Parsed parsed = parse("plain: 007\nquoted: \"007\"\nsingle: '~'\n");
  ASSERT_TRUE(parsed.root);
  EXPECT_EQ(parsed.root->entries[0].value.text, "007");
  EXPECT_FALSE(parsed.root->entries[0].value.quoted);
  EXPECT_TRUE(parsed.root->entries[1].value.quoted);
  EXPECT_EQ(parsed.root->entries[2].value.kind, YamlNode::Kind::scalar);
}

TEST(yaml_document, null_is_written_in_five_ways) {
  const Parsed parsed = parse("a:\nb: ~\nc: null\nd: Null\ne: NULL\n");
  ASSERT_TRUE(parsed.root);
  for (const YamlEntry& entry : parsed.root->entries) EXPECT_EQ(entry.value.kind, YamlNode::Kind::null) << entry.key;
}

TEST(yaml_document, a_repeated_key_is_reported_with_the_line_of_the_first) {
  const std::string error = first_error("group:\n  a: 1\n  b: 2\n  a: 3\n");
  EXPECT_NE(error.find("a.yaml:4: group.a"), std::string::npos) << error;
  EXPECT_NE(error.find("line 2"), std::string::npos) << error;
}

TEST(yaml_document, the_same_key_in_two_groups_is_no_repetition) {
  EXPECT_EQ(first_error("a: {x: 1}\nb: {x: 2}\nlist: [{x: 3}, {x: 4}]\n"), "");
}

TEST(yaml_document, anchors_aliases_and_tags_are_rejected_at_their_place) {
  EXPECT_NE(first_error("a: {b: &x 1}\n").find("a.b: found an anchor"), std::string::npos);
  EXPECT_NE(first_error("a: &x 1\nb: [*x]\n").find("an anchor"), std::string::npos);
  EXPECT_NE(first_error("a: [1, !int 2]\n").find("a[1]: found the tag"), std::string::npos);
  // All of them are reported, and the rest of the text is read.
  const Parsed parsed = parse("a: &x 1\nb: *x\nc: 3\n");
  EXPECT_EQ(parsed.diagnostics.error_count(), 2);
  ASSERT_TRUE(parsed.root);
  EXPECT_EQ(parsed.root->entries.size(), 3U);
}

TEST(yaml_document, a_key_is_a_word) {
  EXPECT_NE(first_error("? [a, b]\n: 1\n").find("a key that is not plain text"), std::string::npos);
}

TEST(yaml_document, there_is_one_document) {
  EXPECT_NE(first_error("a: 1\n---\nb: 2\n").find("a.yaml:3: "), std::string::npos);
  EXPECT_FALSE(parse("").root);
  EXPECT_FALSE(parse("").diagnostics.has_errors());
}

TEST(yaml_document, what_is_no_yaml_is_reported_with_a_useful_message) {
  EXPECT_NE(first_error("a: [1, 2\nb: 3\n").find("not closed with ']'"), std::string::npos);
  EXPECT_NE(first_error("a: b: c\n").find("second ':'"), std::string::npos);
}

}  // namespace
}  // namespace overbend
