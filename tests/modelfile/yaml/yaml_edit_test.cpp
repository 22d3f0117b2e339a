// Keys are changed where they stand; everything else of the text stays.
#include "modelfile/yaml/yaml_edit.h"

#include <gtest/gtest.h>

#include "modelfile/reading/yaml_reader.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

using Kind = YamlChange::Kind;

std::string set(const std::string& text, const std::string& path, const std::string& value) {
  return edit_yaml(text, {{path, Kind::scalar, value}});
}

std::string removed(const std::string& text, const std::string& path) {
  return edit_yaml(text, {{path, Kind::remove, ""}});
}

const std::string kText = R"(# head
a: 1            # one
b:
  c: "two"      # quoted
  # a remark
  d: {e: 3 m, f: [1, 2]}   # flow

list:
- x: 1
  y: 2
- {x: 3, y: 4}
empty:
last: end of it
)";

std::string with(const std::string& old, const std::string& new_text) {
  std::string text = kText;
  return text.replace(text.find(old), old.size(), new_text);
}

TEST(yaml_edit, a_value_is_replaced_where_it_stands) {
  EXPECT_EQ(set(kText, "a", "5"), with("a: 1 ", "a: 5 "));
  EXPECT_EQ(set(kText, "b.c", "three"), with("\"two\"", "\"three\""));
  EXPECT_EQ(set(kText, "b.d.e", "3.5 m"), with("3 m", "3.5 m"));
  EXPECT_EQ(set(kText, "b.d.f[1]", "7"), with("[1, 2]", "[1, 7]"));
  EXPECT_EQ(set(kText, "list[0].y", "8"), with("y: 2", "y: 8"));
  EXPECT_EQ(set(kText, "list[1].x", "8"), with("x: 3", "x: 8"));
  EXPECT_EQ(set(kText, "last", "start"), with("end of it", "start"));
  EXPECT_EQ(set(kText, "empty", "no more"), with("empty:", "empty: no more"));
}

TEST(yaml_edit, a_quoted_value_gives_way_to_one_with_quotation_marks_or_backslashes) {
  for (const std::string value : {"12\" pipe", "it's \"x\"", "a\\b", "\"x\": y"}) {
    for (const std::string before : {"t: \"yes\"   # kept\n", "t: 'yes'   # kept\n"}) {
      const std::string new_text = set(before, "t", value);
      EXPECT_NE(new_text.find("   # kept"), std::string::npos) << new_text;
    }
  }
  EXPECT_EQ(set("t: \"yes\"\n", "t", "12\" pipe"), "t: 12\" pipe\n");
  EXPECT_EQ(set("t: \"yes\"\n", "t", "no"), "t: \"no\"\n");
}

TEST(yaml_edit, a_value_that_would_mislead_is_put_in_quotes) {
  EXPECT_EQ(set(kText, "last", "a: b"), with("end of it", "\"a: b\""));
  EXPECT_EQ(set(kText, "last", "x # y"), with("end of it", "\"x # y\""));
  EXPECT_EQ(set(kText, "b.d.e", "1, 2"), with("3 m", "\"1, 2\""));
  EXPECT_EQ(set(kText, "last", "say \"it\""), with("end of it", "say \"it\""));
  EXPECT_EQ(set(kText, "last", ""), with("end of it", "\"\""));
  EXPECT_EQ(set(kText, "last", "~"), with("end of it", "\"~\""));
}

TEST(yaml_edit, a_missing_key_is_put_behind_its_neighbours) {
  EXPECT_EQ(set(kText, "b.new", "9"), with("# flow\n", "# flow\n  new: 9\n"));
  EXPECT_EQ(set(kText, "b.d.g", "9"), with("[1, 2]}", "[1, 2], g: 9}"));
  EXPECT_EQ(set(kText, "list[0].z", "9"), with("  y: 2\n", "  y: 2\n  z: 9\n"));
  EXPECT_EQ(set(kText, "new", "9"), kText + "new: 9\n");
  EXPECT_EQ(set("a: 1", "b", "2"), "a: 1\nb: 2\n");
  EXPECT_EQ(set("a: {}\n", "a.b", "2"), "a: {b: 2}\n");
}

TEST(yaml_edit, missing_groups_are_made) {
  EXPECT_EQ(set(kText, "b.new.deep", "9"), with("# flow\n", "# flow\n  new:\n    deep: 9\n"));
  EXPECT_EQ(set(kText, "b.d.g.h", "9"), with("[1, 2]}", "[1, 2], g: {h: 9}}"));
  EXPECT_EQ(set(kText, "new[0].x", "9"), kText + "new: [{x: 9}]\n");
  EXPECT_EQ(set(kText, "empty.x", "9"), with("empty:", "empty: {x: 9}"));
  EXPECT_EQ(set(kText, "a.x", "9"), with("a: 1 ", "a: {x: 9} "));
}

TEST(yaml_edit, a_new_list_of_groups_has_an_item_a_line) {
  EXPECT_EQ(edit_yaml(kText, {{"b.new[0]", Kind::flow, "{x: 9}"}, {"b.new[1]", Kind::flow, "{x: 8}"}}),
            with("# flow\n", "# flow\n  new:\n    - {x: 9}\n    - {x: 8}\n"));
}

TEST(yaml_edit, a_list_grows_at_its_end_only) {
  EXPECT_EQ(edit_yaml(kText, {{"list[2]", Kind::flow, "{x: 5, y: 6}"}}), with("y: 4}\n", "y: 4}\n- {x: 5, y: 6}\n"));
  EXPECT_EQ(set(kText, "b.d.f[2]", "3"), with("[1, 2]", "[1, 2, 3]"));
  EXPECT_EQ(set(kText, "list[2].x", "5"), with("y: 4}\n", "y: 4}\n- {x: 5}\n"));
  EXPECT_THROW(set(kText, "list[3].x", "5"), YamlEditError);
}

TEST(yaml_edit, a_group_gives_way_to_a_word_and_back) {
  EXPECT_EQ(set(kText, "b.d", "fixed"), with("{e: 3 m, f: [1, 2]}", "fixed"));
  EXPECT_EQ(set(kText, "b", "fixed"),
            with("b:\n  c: \"two\"      # quoted\n  # a remark\n  d: {e: 3 m, f: [1, 2]}   # flow\n", "b: fixed\n"));
}

TEST(yaml_edit, a_key_is_removed_with_its_line) {
  EXPECT_EQ(removed(kText, "a"), with("a: 1            # one\n", ""));
  EXPECT_EQ(removed(kText, "b.d"), with("  d: {e: 3 m, f: [1, 2]}   # flow\n", ""));
  EXPECT_EQ(removed(kText, "b.d.e"), with("e: 3 m, ", ""));
  EXPECT_EQ(removed(kText, "b.d.f"), with(", f: [1, 2]", ""));
  EXPECT_EQ(removed(kText, "list[0].x"), with("- x: 1\n  y: 2", "- y: 2"));
  EXPECT_EQ(removed(kText, "list[0]"), with("- x: 1\n  y: 2\n", ""));
  EXPECT_EQ(removed(kText, "list[1]"), with("- {x: 3, y: 4}\n", ""));
  EXPECT_EQ(removed(kText, "empty"), with("empty:\n", ""));
  EXPECT_EQ(removed(kText, "b.nothing"), kText);
}

TEST(yaml_edit, a_group_that_loses_its_last_key_goes_with_it) {
  EXPECT_EQ(removed("a: 1\nb:\n  c:\n    d: 1\n", "b.c.d"), "a: 1\n");
  EXPECT_EQ(removed("a: 1\nb: {c: {d: 1}}\n", "b.c.d"), "a: 1\n");
  EXPECT_THROW(removed("a: 1\n", "a"), YamlEditError);
}

TEST(yaml_edit, names_may_hold_blanks_and_points) {
  EXPECT_EQ(set("r:\n  v 1.5: {b: 1}\n", "r.v 1.5.b", "2"), "r:\n  v 1.5: {b: 2}\n");
}

TEST(yaml_edit, line_breaks_of_windows_stay) {
  EXPECT_EQ(set("a: 1\r\nb: 2\r\n", "a", "3"), "a: 3\r\nb: 2\r\n");
  EXPECT_EQ(set("a: 1\r\nb: 2\r\n", "c", "3"), "a: 1\r\nb: 2\r\nc: 3\r\n");
}

TEST(yaml_edit, letters_beyond_ascii_do_not_shift_places) {
  EXPECT_EQ(set("t: {n: Ölpfad – süd, v: 1}\n", "t.v", "2"), "t: {n: Ölpfad – süd, v: 2}\n");
}

TEST(yaml_edit, what_it_does_not_understand_it_leaves_and_says_so) {
  EXPECT_THROW(set("a: |\n  text\n  more\nb: 1\n", "a", "2"), YamlEditError);
  EXPECT_THROW(set("a: [1\n", "a", "2"), YamlEditError);
  EXPECT_THROW(set("a: 1\n", "a[0][1]", "2"), YamlEditError);
  EXPECT_THROW(set("", "a", "2"), YamlEditError);
}

TEST(yaml_edit, every_value_of_the_example_can_be_set_and_reads_the_same) {
  const std::string text = testing::file_text(OVERBEND_SOURCE_DIR "/examples/bgl1.yaml");
  for (const auto& [path, value] : {std::pair{"tensioner.tension", "260 kN"},
                                    {"supports.stinger.boxes[3].z", "-5 m"},
                                    {"supports.stinger.boxes[0].offset", "0.1 m"},
                                    {"vessel.trim", "1 deg"},
                                    {"analysis.mesh.overbend_element", "1 m"}}) {
    const ModelReading reading = read_model_text(set(text, path, value), OVERBEND_SOURCE_DIR "/examples/bgl1.yaml");
    EXPECT_TRUE(reading.description) << path;
  }
}

TEST(yaml_edit, a_tree_takes_the_same_simple_changes_as_the_text) {
  Diagnostics errors;
  YamlNode root = *parse_yaml(kText, "", errors);
  ASSERT_TRUE(edit_tree(
      root, {{"b.d.e", Kind::scalar, "4 m"}, {"list[1].y", Kind::scalar, "9"}, {"b.new", Kind::scalar, "5"}}));
  EXPECT_EQ(root.entries[1].value.entries[1].value.entries[0].value.text, "4 m");
  EXPECT_EQ(root.entries[2].value.items[1].entries[1].value.text, "9");
  EXPECT_EQ(root.entries[1].value.entries.back().key, "new");
  EXPECT_FALSE(edit_tree(root, {{"list", Kind::scalar, "1"}}));
  EXPECT_FALSE(edit_tree(root, {{"no.such.group", Kind::scalar, "1"}}));
  EXPECT_FALSE(edit_tree(root, {{"a", Kind::remove, ""}}));
}

TEST(yaml_edit, a_path_deeper_than_any_key_is_rejected_shortly) {
  std::string path = "a";
  for (int i = 0; i < 30000; ++i) path += ".a";
  try {
    edit_yaml("b: 1\n", {{path, YamlChange::Kind::scalar, "2"}});
    FAIL() << "accepted";
  } catch (const YamlEditError& error) {
    EXPECT_LT(std::string(error.what()).size(), 200U);
  }
  YamlNode root;
  root.kind = YamlNode::Kind::map;
  EXPECT_FALSE(edit_tree(root, {{path, YamlChange::Kind::scalar, "2"}}));
}

}  // namespace
}  // namespace overbend
