#include "results/shared_warnings.h"

#include <gtest/gtest.h>

namespace overbend {
namespace {

using Runs = std::vector<std::vector<std::string>>;

TEST(shared_warnings, that_are_the_same_are_told_once_with_how_many_runs_have_them) {
  const auto shared = shared_warnings(Runs{{"steel yields", "the run is short"}, {"the run is short"}, {}});
  ASSERT_EQ(shared.size(), 2u);
  EXPECT_EQ(shared[0].text, "steel yields");
  EXPECT_EQ(shared[0].runs, 1);
  EXPECT_EQ(shared[1].text, "the run is short");
  EXPECT_EQ(shared[1].runs, 2);
}

TEST(shared_warnings, that_differ_in_numbers_alone_give_their_range) {
  const auto shared = shared_warnings(Runs{{"falls to -6.90 kN at t = 91.9 s, of 250.0 kN"},
                                           {"falls to -155.94 kN at t = 8.2e+01 s, of 250.0 kN"},
                                           {"falls to -31.5 kN at t = 100.4 s, of 250.0 kN"}});
  ASSERT_EQ(shared.size(), 1u);
  EXPECT_EQ(shared[0].text, "falls to -155.94 .. -6.90 kN at t = 8.2e+01 .. 100.4 s, of 250.0 kN");
  EXPECT_EQ(shared[0].runs, 3);
}

TEST(shared_warnings, numbers_in_quotes_and_words_are_names) {
  const auto shared = shared_warnings(Runs{{"left 'stinger 4' by DNV-ST-F101 (5th)", "left 'stinger 5' by case-1"},
                                           {"left 'stinger 4' by DNV-ST-F102 (5th)", "left 'stinger 5' by case-2"}});
  EXPECT_EQ(shared.size(), 4u);
  EXPECT_EQ(shared_warnings(Runs{{"line \"wire 1\" parts"}, {"line \"wire 2\" parts"}}).size(), 2u);
}

TEST(shared_warnings, an_apostrophe_opens_no_quotes) {
  const auto shared = shared_warnings(Runs{{"the barge's heave of 2.5 m"}, {"the barge's heave of 3.5 m"}});
  ASSERT_EQ(shared.size(), 1u);
  EXPECT_EQ(shared[0].text, "the barge's heave of 2.5 .. 3.5 m");
}

TEST(shared_warnings, of_one_run_count_once) {
  const auto shared = shared_warnings(Runs{{"row 3. Gone at 1 s", "row 4. Gone at 2 s"}});
  ASSERT_EQ(shared.size(), 1u);
  EXPECT_EQ(shared[0].text, "row 3 .. 4. Gone at 1 .. 2 s");
  EXPECT_EQ(shared[0].runs, 1);
}

}  // namespace
}  // namespace overbend
