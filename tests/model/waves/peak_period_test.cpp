#include "model/waves/peak_period.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/constants.h"
#include "model/waves/wave_theory.h"

namespace overbend {
namespace {

TEST(peak_period, has_the_published_ratios_to_the_zero_crossing_period) {
  EXPECT_NEAR(tp_over_tz(1.0), std::pow(1.25 * kPi, 0.25), 1e-8);  // closed form
  EXPECT_NEAR(tp_over_tz(1.0), 1.4077, 5e-5);
  EXPECT_NEAR(tp_over_tz(3.3), 1.2863, 5e-5);
  EXPECT_NEAR(tp_over_tz(3.3), 1.286340390, 1e-8);  // by a finer rule over all frequencies
  double before = 2.0;
  for (const double gamma : {1.0, 2.0, 5.0, 10.0}) {
    EXPECT_LT(tp_over_tz(gamma), before);
    before = tp_over_tz(gamma);
  }
}

TEST(peak_period, without_gamma_agrees_with_the_rule_for_the_period_that_it_gives) {
  for (const double hs : {0.5, 2.0, 3.0, 3.6, 4.2, 9.0, 12.0}) {
    for (const double tz : {2.0, 5.0, 6.0, 7.0, 10.0, 14.0}) {
      const double tp = peak_period(hs, tz, {});
      EXPECT_NEAR(tp / tz, tp_over_tz(jonswap_gamma(hs, tp)), 1e-9) << hs << " " << tz;
    }
  }
  EXPECT_DOUBLE_EQ(peak_period(2.0, 6.0, 1.0), 6.0 * tp_over_tz(1.0));
}

}  // namespace
}  // namespace overbend
