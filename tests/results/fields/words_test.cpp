#include "results/result_words.h"

#include <gtest/gtest.h>

namespace overbend {
namespace {

template <class Enum>
void expect_words_lead_back() {
  for (const auto& [value, text] : Words<Enum>::list) {
    Enum found{};
    EXPECT_TRUE(from_word(word(value), found)) << text;
    EXPECT_EQ(found, value) << text;
  }
}

TEST(words, lead_back_to_their_enumerators) {
  expect_words_lead_back<Region>();
  expect_words_lead_back<CheckRegion>();
  expect_words_lead_back<CheckStatus>();
  expect_words_lead_back<RollerPosition>();
  expect_words_lead_back<Structure>();
  Region unchanged = Region::sagbend;
  EXPECT_FALSE(from_word("nowhere", unchanged));
  EXPECT_EQ(unchanged, Region::sagbend);
}

}  // namespace
}  // namespace overbend
