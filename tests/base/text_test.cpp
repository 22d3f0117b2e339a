#include "base/text.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace overbend {
namespace {

TEST(text, edit_distance_counts_insertions_deletions_changes_and_swaps) {
  EXPECT_EQ(edit_distance("", "abc"), 3);
  EXPECT_EQ(edit_distance("abc", "abc"), 0);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
  EXPECT_EQ(edit_distance("lenght", "length"), 1);
  EXPECT_EQ(edit_distance("stifness", "stiffness"), 1);
}

TEST(text, nearest_word_finds_what_was_meant) {
  const std::vector<std::string> known = {"outside_diameter", "wall_thickness", "yield_stress", "x", "z"};
  EXPECT_EQ(nearest_word("wall_thicknes", known), "wall_thickness");
  EXPECT_EQ(nearest_word("Wall_Thickness", known), "wall_thickness");
  EXPECT_EQ(nearest_word("diameter", known), "outside_diameter");
  EXPECT_EQ(nearest_word("yeild_stress", known), "yield_stress");
}

TEST(text, nearest_word_keeps_silent_when_nothing_is_near) {
  EXPECT_EQ(nearest_word("colour", {"outside_diameter", "x", "z"}), "");
  EXPECT_EQ(nearest_word("a", {"b"}), "");
  EXPECT_EQ(nearest_word("", {"b"}), "");
  EXPECT_EQ(nearest_word(std::string(10000, 'a'), {"b"}), "");
}

TEST(text, display_is_one_short_line_and_never_cuts_a_character) {
  EXPECT_EQ(for_display("a\nb\tc"), "a?b?c");
  EXPECT_EQ(for_display("abcdef", 3), "abc...");
  EXPECT_EQ(for_display("ab\xc3\xa9", 3), "ab...");
  EXPECT_EQ(for_display("ab\xc3\xa9", 4), "ab\xc3\xa9");
}

TEST(text, items_join_to_a_sentence) {
  EXPECT_EQ(join_items({"a", "b", "c"}, "or"), "a, b or c");
  EXPECT_EQ(join_choices({"a"}), "'a'");
  EXPECT_EQ(join_choices({"a", "b"}), "one of a or b");
}

/// A word as a shell reads it, followed by another.
std::string as_a_shell_reads(const std::string& text) {
  FILE* pipe = popen(("printf '<%s>' " + shell_word(text) + " end").c_str(), "r");
  std::string read;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) read += static_cast<char>(c);
  pclose(pipe);
  return read;
}

TEST(text, arguments_of_the_shell_are_taken_letter_for_letter) {
  for (const std::string text :
       {"a 'b' \"c\" $(touch x) `d` ; e\n\\ * ~", "'", "''", "", "#", "~", "plain/word-1.yaml", "\u00fc", "a=b", "!"}) {
    EXPECT_EQ(as_a_shell_reads(text), "<" + text + "><end>");
  }
}

TEST(text, arguments_that_a_shell_takes_as_they_are_go_without_quotes) {
  EXPECT_EQ(shell_word("results/run-1.study"), "results/run-1.study");
  EXPECT_EQ(shell_word("o'neil"), "'o'\\''neil'");
  EXPECT_EQ(shell_word(""), "''");
}

}  // namespace
}  // namespace overbend
