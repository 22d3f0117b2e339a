#include "base/assumption.h"

#include <gtest/gtest.h>

namespace overbend {
namespace {

const Assumptions kThree = {{AssumptionRank::setting, "The sea is long-crested."},
                            {AssumptionRank::governing, "The vessel does not move."},
                            {AssumptionRank::other, "There is no wind."}};

TEST(assumption, comes_back_from_its_sentence_and_the_name_of_its_rank) {
  EXPECT_EQ(read_assumptions(texts(kThree), rank_names(kThree)), kThree);
  EXPECT_EQ(rank_names(kThree), (std::vector<std::string>{"setting", "governing", "other"}));
}

TEST(assumption, stored_without_a_rank_or_with_an_unknown_one_is_one_of_the_others) {
  const Assumptions all = read_assumptions({"a", "b"}, {"of a later version"});
  EXPECT_EQ(texts(all, AssumptionRank::other), (std::vector<std::string>{"a", "b"}));
}

TEST(assumption, is_reported_once_for_two_results) {
  const Assumptions all = merge(kThree, {kThree[1], {AssumptionRank::other, "There is no ice."}});
  ASSERT_EQ(all.size(), 4U);
  EXPECT_EQ(all.back().text, "There is no ice.");
  EXPECT_EQ(texts(all, AssumptionRank::governing), (std::vector<std::string>{"The vessel does not move."}));
}

}  // namespace
}  // namespace overbend
