#include "resultfiles/studies/seeds_writer.h"

#include <gtest/gtest.h>

namespace overbend {
namespace {

SeedsResults seeds_with(std::initializer_list<VerdictKind> verdicts) {
  SeedsResults results;
  for (const VerdictKind verdict : verdicts) {
    SeedRun run;
    run.verdict = verdict;
    results.runs.push_back(run);
  }
  return results;
}

TEST(seeds_writer, the_verdict_on_all_seeds_is_the_most_severe_of_one) {
  using enum VerdictKind;
  EXPECT_EQ(worst_verdict(seeds_with({passed, passed})), passed);
  EXPECT_EQ(worst_verdict(seeds_with({passed, reserved, passed})), reserved);
  EXPECT_EQ(worst_verdict(seeds_with({exceeded, not_judged, reserved})), exceeded);
  EXPECT_EQ(seeds_json(seeds_with({passed, reserved}))["verdict"], "reserved");
  EXPECT_EQ(seeds_json(seeds_with({passed, reserved}))["runs"][0]["verdict"], "passed");
}

TEST(seeds_writer, a_seed_that_failed_leaves_all_of_them_without_a_verdict_unless_another_is_exceeded) {
  SeedsResults results = seeds_with({VerdictKind::passed});
  results.failed.push_back({7, "no equilibrium"});
  EXPECT_EQ(worst_verdict(results), VerdictKind::not_judged);
  EXPECT_EQ(worst_verdict({}), VerdictKind::not_judged);
  results.runs.front().verdict = VerdictKind::exceeded;
  EXPECT_EQ(worst_verdict(results), VerdictKind::exceeded);
}

}  // namespace
}  // namespace overbend
