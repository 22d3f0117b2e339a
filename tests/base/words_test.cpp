#include "base/words.h"

#include <gtest/gtest.h>

#include <array>
#include <stdexcept>

namespace overbend {
namespace {

enum class Weather { calm, rough, unheard_of };

}  // namespace

// Not in the order of the enumerators: a word belongs to its enumerator, not to a position.
template <>
inline constexpr std::array kWords<Weather> = {Word{Weather::rough, "rough"}, Word{Weather::calm, "calm"}};

namespace {

TEST(words, each_stands_for_its_enumerator_whatever_the_order) {
  EXPECT_STREQ(word_of(Weather::calm), "calm");
  EXPECT_STREQ(word_of(Weather::rough), "rough");
  EXPECT_EQ(from_word<Weather>("calm"), Weather::calm);
  EXPECT_EQ(from_word<Weather>("rough"), Weather::rough);
  EXPECT_EQ(words_of<Weather>(), (std::vector<std::string>{"rough", "calm"}));
}

TEST(words, any_other_text_is_no_word) {
  for (const char* text : {"", "Calm", "calm ", "storm"}) EXPECT_FALSE(from_word<Weather>(text)) << text;
}

TEST(words, an_enumerator_without_a_word_is_a_broken_promise) {
  EXPECT_THROW(word_of(Weather::unheard_of), std::logic_error);
}

TEST(words, only_enumerations_with_a_list_have_words) {
  EXPECT_TRUE(HasWords<Weather>);
  EXPECT_FALSE(HasWords<int>);
}

}  // namespace
}  // namespace overbend
