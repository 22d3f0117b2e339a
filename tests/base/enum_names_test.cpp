#include "base/enum_names.h"

#include <gtest/gtest.h>

#include <array>
#include <stdexcept>

namespace overbend {
namespace {

enum class Weather { calm, rough, unknown };

}  // namespace

// Not in the order of the enumerators: a word belongs to its enumerator, not to a position.
template <>
inline constexpr std::array kEnumNames<Weather> = {Word{Weather::rough, "rough"}, Word{Weather::calm, "calm"}};

namespace {

TEST(label, each_stands_for_its_enumerator_whatever_the_order) {
  EXPECT_STREQ(enum_name(Weather::calm), "calm");
  EXPECT_STREQ(enum_name(Weather::rough), "rough");
  EXPECT_EQ(from_enum_name<Weather>("calm"), Weather::calm);
  EXPECT_EQ(from_enum_name<Weather>("rough"), Weather::rough);
  EXPECT_EQ(enum_names<Weather>(), (std::vector<std::string>{"rough", "calm"}));
}

TEST(label, any_other_text_is_no_word) {
  for (const char* text : {"", "Calm", "calm ", "storm"}) EXPECT_FALSE(from_enum_name<Weather>(text)) << text;
}

TEST(label, an_enumerator_without_a_word_is_a_broken_promise) {
  EXPECT_THROW(enum_name(Weather::unknown), std::logic_error);
}

TEST(label, only_enumerations_with_a_list_have_names) {
  EXPECT_TRUE(HasEnumNames<Weather>);
  EXPECT_FALSE(HasEnumNames<int>);
}

}  // namespace
}  // namespace overbend
