#include "model/site/sea_statistics.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/constants.h"

namespace overbend {
namespace {

/// Pierson-Moskowitz: Tz = Tp / 1.4079 [DNV-RP-C205, 3.5.5].
TEST(sea_statistics, give_the_periods_of_a_pierson_moskowitz_sea) {
  const double hs = 3.0, tp = 9.0, wp = kTurn / tp;
  std::vector<SpectrumPoint> points;
  for (double w = 0.2; w < 12.0; w += 0.002) {
    points.push_back(
        {w, 5.0 / 16.0 * hs * hs * std::pow(wp, 4) * std::pow(w, -5) * std::exp(-1.25 * std::pow(wp / w, 4))});
  }
  const SeaStatistics sea = sea_statistics(points);
  EXPECT_NEAR(sea.hs, hs, 2e-3);           // the tail beyond 12 rad/s has 3e-4 of the energy
  EXPECT_NEAR(sea.tp, tp, 0.03);           // a point every 0.002 rad/s
  EXPECT_NEAR(sea.tz, tp / 1.4079, 0.02);  // the tail of m2
  EXPECT_EQ(sea_statistics_label({{0.5, 0.0}, {0.6, 2.0}, {0.7, 0.0}}).substr(0, 9), "Hs 1.79 m");
}

TEST(sea_statistics, of_a_triangle_are_exact) {
  const SeaStatistics sea = sea_statistics({{1.0, 0.0}, {2.0, 3.0}, {3.0, 0.0}});
  // m0 = 3, m2 = int_1^2 w^2 3 (w - 1) dw + int_2^3 w^2 3 (3 - w) dw = 4.25 + 8.25
  EXPECT_DOUBLE_EQ(sea.hs, 4.0 * std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(sea.tz, kTurn * std::sqrt(3.0 / 12.5));
  EXPECT_DOUBLE_EQ(sea.tp, kPi);
}

}  // namespace
}  // namespace overbend
