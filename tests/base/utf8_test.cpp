#include "base/utf8.h"

#include <gtest/gtest.h>

namespace overbend {
namespace {

using namespace std::string_literals;

TEST(utf8, characters_of_every_length_stay) {
  const std::string text = "a\u00b5\u20ac\U0001f6a2\n\0"s;
  EXPECT_EQ(valid_utf8(text), text);
  EXPECT_EQ(utf8_length(text, 0), 1U);
  EXPECT_EQ(utf8_length(text, 1), 2U);
  EXPECT_EQ(utf8_length(text, 3), 3U);
  EXPECT_EQ(utf8_length(text, 6), 4U);
}

TEST(utf8, bytes_of_no_character_are_written_out) {
  EXPECT_EQ(valid_utf8("1,\xc6"
                       "5"),
            "1,\\xc65");
  EXPECT_EQ(valid_utf8("\xff\x80z"), "\\xff\\x80z");
  EXPECT_EQ(valid_utf8("cut \xe2\x82"), "cut \\xe2\\x82");
}

TEST(utf8, overlong_forms_surrogates_and_numbers_beyond_unicode_are_no_characters) {
  EXPECT_EQ(valid_utf8("\xc0\xaf"), "\\xc0\\xaf");
  EXPECT_EQ(valid_utf8("\xe0\x80\x80"), "\\xe0\\x80\\x80");
  EXPECT_EQ(valid_utf8("\xed\xa0\x80"), "\\xed\\xa0\\x80");
  EXPECT_EQ(valid_utf8("\xf0\x80\x80\x80"), "\\xf0\\x80\\x80\\x80");
  EXPECT_EQ(valid_utf8("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");
}

TEST(utf8, what_comes_out_is_valid_for_all_pairs_of_bytes) {
  for (int a = 0; a < 256; ++a) {
    for (int b = 0; b < 256; ++b) {
      const std::string valid = valid_utf8(std::string{static_cast<char>(a), static_cast<char>(b)});
      EXPECT_EQ(valid_utf8(valid), valid);
    }
  }
}

}  // namespace
}  // namespace overbend
