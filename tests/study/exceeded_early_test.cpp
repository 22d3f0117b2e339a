#include "study/exceeded_early.h"

#include <gtest/gtest.h>

#include "support/bgl1_in_time.h"
#include "support/memory_sink.h"

namespace overbend {
namespace {

using testing::Case;
using testing::EmptySink;
using testing::MemorySink;
using testing::workable;

/// A sea in which all checks are passed but that of a tension which the waves exceed.
Description with_tension_limit(double limit) {
  Description d = workable();
  d.checks.limits.tension = limit;
  return d;
}

}  // namespace

TEST(exceeded_early, a_run_ends_where_a_check_is_exceeded_and_the_whole_run_exceeds_it_too) {
  EmptySink none;
  const DynamicResults free = Case(workable()).results(none);
  const double top = free.top_tension.max, still = Case(workable()).statics.top_tension;
  ASSERT_GT(top, still);
  const Case c(with_tension_limit(0.5 * (top + still)));
  const DynamicResults whole = c.results(none);
  EXPECT_EQ(worst_check(whole.checks)->id, "tensioner_load");
  EXPECT_EQ(worst_check(whole.checks)->status, CheckStatus::exceeded);

  ExceededEarly exceeded(c.model, c.statics, 0.5);
  double last = 0.0;
  DynamicOutcome outcome = c.run(none, dynamic_options(c.model), nullptr, [&](const DynamicProgress& at) {
    last = at.time;
    return exceeded(at) ? DynamicControl::stop : DynamicControl::go_on;
  });
  ASSERT_TRUE(outcome.stopped && outcome.results);
  EXPECT_LT(last, whole.duration);
  fill_checks(c.model, c.statics, *outcome.results);
  const CheckRow* worst = worst_check(outcome.results->checks);
  EXPECT_EQ(worst->id, "tensioner_load");
  EXPECT_GT(worst->utilisation, 1.0);
  EXPECT_LE(worst->utilisation, worst_check(whole.checks)->utilisation);
}

TEST(exceeded_early, a_run_that_passes_goes_to_its_end_and_gives_the_same_bits) {
  const Case c(workable());
  MemorySink plain, watched;
  const DynamicOptions options = dynamic_options(c.model);
  const DynamicOutcome alone = c.run(plain, options);
  ExceededEarly exceeded(c.model, c.statics, 1.0);
  const DynamicOutcome looked_at = c.run(watched, options, nullptr, [&](const DynamicProgress& at) {
    EXPECT_FALSE(exceeded(at));
    return DynamicControl::go_on;
  });
  EXPECT_FALSE(looked_at.stopped);
  EXPECT_EQ(plain.rows, watched.rows);
  EXPECT_EQ(alone.results->top_tension.max, looked_at.results->top_tension.max);
}

}  // namespace overbend
