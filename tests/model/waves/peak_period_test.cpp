#include "model/waves/peak_period.h"

#include <gtest/gtest.h>

#include "model/waves/wave_theory.h"

namespace overbend {
namespace {

TEST(peak_period, has_the_published_ratios_to_the_zero_crossing_period) {
  EXPECT_NEAR(tp_over_tz(1.0), 1.4077, 5e-5);
  EXPECT_NEAR(tp_over_tz(3.3), 1.2863, 5e-5);
}

TEST(peak_period, without_gamma_agrees_with_the_rule_for_the_period_that_it_gives) {
  for (const double hs : {0.5, 2.0, 3.0, 3.6, 4.2, 9.0}) {
    const double tp = peak_period(hs, 6.0, {});
    EXPECT_NEAR(tp, 6.0 * tp_over_tz(jonswap_gamma(hs, tp)), 1e-9) << hs;
  }
  EXPECT_DOUBLE_EQ(peak_period(2.0, 6.0, 1.0), 6.0 * tp_over_tz(1.0));
}

}  // namespace
}  // namespace overbend
