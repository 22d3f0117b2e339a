#include "numerics/root_scan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace overbend {
namespace {

TEST(root_scan, finds_every_root_to_the_resolution) {
  const RootScan scan = scan_roots([](double x) { return std::sin(x); }, 1.0, 10.0);
  ASSERT_EQ(scan.crossings.size(), 3U);
  for (int i = 0; i < 3; ++i) {
    const Crossing& crossing = scan.crossings[static_cast<std::size_t>(i)];
    EXPECT_FALSE(crossing.jump);
    EXPECT_NEAR(crossing.nearest(), (i + 1) * std::numbers::pi, 1e-7);
  }
}

TEST(root_scan, needs_few_values_beyond_the_grid_for_a_smooth_root) {
  const RootScan scan = scan_roots([](double x) { return std::exp(x) - 3.0; }, 0.0, 2.0);
  ASSERT_EQ(scan.crossings.size(), 1U);
  EXPECT_NEAR(scan.crossings[0].nearest(), std::log(3.0), 1e-8);
  EXPECT_LT(scan.points.size(), 13U + 8U);
}

TEST(root_scan, distinguishes_a_jump_from_a_root) {
  const RootScan scan = scan_roots([](double x) { return x < 0.3 ? x - 0.7 : x - 0.1; }, 0.0, 1.0);
  ASSERT_EQ(scan.crossings.size(), 1U);
  EXPECT_TRUE(scan.crossings[0].jump);
  EXPECT_NEAR(scan.crossings[0].low, 0.3, 1e-7);
  EXPECT_NEAR(scan.crossings[0].high, 0.3, 1e-7);
  EXPECT_NEAR(scan.crossings[0].at_low, -0.4, 1e-6);
  EXPECT_NEAR(scan.crossings[0].at_high, 0.2, 1e-6);
}

TEST(root_scan, a_kink_or_a_steep_root_is_no_jump) {
  const RootScan kink = scan_roots([](double x) { return x < 0.5 ? 1e-4 * (x - 0.5) : 3.0 * (x - 0.5); }, 0.0, 0.97);
  ASSERT_EQ(kink.crossings.size(), 1U);
  EXPECT_FALSE(kink.crossings[0].jump);
  EXPECT_NEAR(kink.crossings[0].nearest(), 0.5, 1e-4);
  const RootScan steep = scan_roots([](double x) { return std::atan(1e3 * (x - 0.41)); }, 0.0, 1.0);
  ASSERT_EQ(steep.crossings.size(), 1U);
  EXPECT_FALSE(steep.crossings[0].jump);
  EXPECT_NEAR(steep.crossings[0].nearest(), 0.41, 1e-8);
}

TEST(root_scan, finds_two_roots_between_neighbours_of_the_grid) {
  // The grid has steps of 1/12: both roots lie within one of them.
  const double middle = 5.5 / 12.0, apart = 0.02;
  const RootScan scan = scan_roots([&](double x) { return (x - middle) * (x - middle) - apart * apart; }, 0.0, 1.0);
  ASSERT_EQ(scan.crossings.size(), 2U);
  EXPECT_NEAR(scan.crossings[0].nearest(), middle - apart, 1e-7);
  EXPECT_NEAR(scan.crossings[1].nearest(), middle + apart, 1e-7);
}

/// A peak between an end and the next point of the grid, from where the values only go away from zero.
TEST(root_scan, finds_two_roots_next_to_an_end_from_which_the_values_begin_to_turn) {
  const auto peak = [](double x) { return 0.4 * x * std::exp(-4.0 * x) - 0.01 * x - 0.02; };
  for (const bool mirrored : {false, true}) {
    const RootScan scan = scan_roots([&](double x) { return peak(mirrored ? 12.0 - x : x); }, 0.0, 12.0);
    ASSERT_EQ(scan.crossings.size(), 2U);
    for (const Crossing& crossing : scan.crossings)
      EXPECT_NEAR(peak(mirrored ? 12.0 - crossing.nearest() : crossing.nearest()), 0.0, 1e-8);
  }
}

TEST(root_scan, a_gap_hides_no_root_next_to_it_and_makes_none) {
  const auto f = [](double x) -> std::optional<double> {
    if (x > 0.4 && x < 0.6) return std::nullopt;
    return x < 0.5 ? x - 0.2 : x - 2.0;
  };
  const RootScan scan = scan_roots(f, 0.0, 1.0);
  ASSERT_EQ(scan.crossings.size(), 1U);
  EXPECT_NEAR(scan.crossings[0].nearest(), 0.2, 1e-8);
  EXPECT_FALSE(scan.crossings[0].jump);
}

TEST(root_scan, encloses_a_root_from_both_sides_where_a_limit_asks_for_it) {
  // Values of zero but for rounding are met on one side of the root long before the bracket is narrow.
  const auto f = [](double x) { return std::expm1(x - 0.3); };
  ScanSettings settings;
  settings.both_ends = true;
  for (const double sign : {1.0, -1.0}) {
    const RootScan scan = scan_roots([&](double x) { return sign * f(x); }, 0.0, 1.0, settings);
    ASSERT_EQ(scan.crossings.size(), 1U);
    const Crossing& crossing = scan.crossings[0];
    EXPECT_LT(crossing.high - crossing.low, 1e-7);
    EXPECT_LE(crossing.low, 0.3);
    EXPECT_GE(crossing.high, 0.3);
    EXPECT_LE(sign * crossing.at_low, 0.0);
    EXPECT_GE(sign * crossing.at_high, 0.0);
  }
}

TEST(root_scan, says_whether_the_function_is_monotone) {
  EXPECT_TRUE(is_monotone(scan_roots([](double x) { return std::exp(-x); }, 0.0, 3.0)));
  EXPECT_FALSE(is_monotone(scan_roots([](double x) { return std::sin(x); }, 0.0, 3.0)));
}

}  // namespace
}  // namespace overbend
