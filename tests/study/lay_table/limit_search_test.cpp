#include "study/lay_table/limit_search.h"

#include <gtest/gtest.h>

#include <cmath>

namespace overbend {
namespace {

/// A lay whose only check is used that much; none from 1 on.
TryLay make_lays(std::function<double(double)> utilisation) {
  return [utilisation = std::move(utilisation)](double value) {
    LayTableValues values;
    values.utilisation = utilisation(value);
    values.verdict = *values.utilisation <= 1.0 ? VerdictKind::passed : VerdictKind::exceeded;
    return LayCase{value, 0.0, values, values.passed() ? "" : "a check is exceeded"};
  };
}

MinPassingLay find_min_pass(const TryLay& lays, double from, double to) {
  return find_min_passing(from, to, {}, lays, lays);
}

TEST(limit_search, the_least_that_passes_is_that_of_the_lower_of_two_stretches) {
  const TryLay lays = make_lays([](double x) { return (x > 1.4 && x < 1.85) || (x > 2.0 && x < 2.6) ? 0.9 : 1.2; });
  const MinPassingLay min_lay = find_min_pass(lays, 0.05, 5.0);
  ASSERT_TRUE(min_lay.limit);
  EXPECT_NEAR(min_lay.limit->passing.value, 1.4, 1.4e-3);  // the tolerance of a limit, a thousandth of it
  EXPECT_LE(min_lay.limit->beyond.value, 1.4);
}

/// One check falls with the value and another rises: both hold over less than a step.
TEST(limit_search, a_stretch_shorter_than_a_step_is_found) {
  const auto min_used = [](double x) { return std::max(1.0 - 2.0 * (x - 1.0), 1.0 + 2.0 * (x - 1.01)); };
  int stretches = 0;
  for (double begin = 0.1; begin < 0.105; begin += 0.0004) {  // wherever the steps fall
    const MinPassingLay min_lay = find_min_pass(make_lays(min_used), begin, 10.0);
    if (!min_lay.limit) continue;
    ++stretches;
    EXPECT_NEAR(min_lay.limit->passing.value, 1.0, 1e-3);
  }
  EXPECT_EQ(stretches, 13);
}

TEST(limit_search, without_a_lay_that_passes_the_whole_range_was_tried) {
  const MinPassingLay none = find_min_pass(make_lays([](double x) { return 1.5 + std::abs(x - 1.0); }), 0.1, 10.0);
  EXPECT_FALSE(none.limit);
  EXPECT_EQ(none.tried.front().value, 0.1);
  EXPECT_EQ(none.tried.back().value, 10.0);
  double nearest = 10.0;
  for (const TriedLay& tried_lay : none.tried) nearest = std::min(nearest, tried_lay.lay.lay->utilisation.value());
  EXPECT_NEAR(nearest, 1.5, 2e-3);
}

TEST(limit_search, a_lay_that_passes_at_the_least_value_has_nothing_beyond_it) {
  const MinPassingLay min_lay = find_min_pass(make_lays([](double) { return 0.5; }), 0.1, 10.0);
  ASSERT_TRUE(min_lay.limit);
  EXPECT_EQ(min_lay.limit->passing.value, 0.1);
  EXPECT_EQ(min_lay.limit->beyond.value, 0.1);
}

}  // namespace
}  // namespace overbend
