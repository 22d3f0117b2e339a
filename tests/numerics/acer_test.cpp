#include "numerics/acer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace overbend {
namespace {

constexpr double kPeaks = 1000.0;  ///< In the reference time.
constexpr double kReference = 10800.0;

double uniform(std::mt19937_64& generator) {
  return (static_cast<double>(generator() >> 11) + 0.5) * 0x1.0p-53;
}

/// Two independent normal variables are the parts of this (Box and Muller 1958).
double rayleigh(std::mt19937_64& generator) {
  return std::sqrt(-2.0 * std::log(uniform(generator)));
}

template <class Next>
std::vector<PeakRecord> records(int runs, int each, Next next) {
  std::vector<PeakRecord> all;
  for (int i = 0; i < runs; ++i) {
    PeakRecord record{{}, each * kReference / kPeaks};
    for (int j = 0; j < each; ++j) record.peaks.push_back(next());
    all.push_back(record);
  }
  return all;
}

/// Amplitudes of a narrow-band process whose envelope forgets slowly: Rayleigh peaks in groups. The two quadratures
/// are autoregressive of first order with correlation 0.8 from peak to peak.
struct Groups {
  std::mt19937_64 generator;
  double x = 0.0, y = 0.0;

  double operator()() {
    const double size = 0.6 * rayleigh(generator), angle = 2.0 * 3.14159265358979 * uniform(generator);
    x = 0.8 * x + size * std::cos(angle);
    y = 0.8 * y + size * std::sin(angle);
    return std::hypot(x, y);
  }
};

TEST(acer, rates_of_first_order_are_the_fraction_of_peaks_above) {
  const std::vector<PeakRecord> seen = {{{1, 3, 2, 5, 1, 4}, 60.0}, {{2, 2, 6, 1, 1, 3}, 60.0}};
  const std::vector<double> levels = {1.5};
  const std::vector<AcerLevel> rates = exceedance_rates(seen, 1, levels);
  ASSERT_EQ(rates.size(), 1u);
  EXPECT_DOUBLE_EQ(rates[0].rate, 8.0 / 12.0);
}

TEST(acer, a_peak_counts_for_a_higher_order_only_after_peaks_below) {
  const std::vector<PeakRecord> seen(4, {{1, 3, 3, 1, 1, 3, 1, 1, 3}, 60.0});
  const std::vector<double> levels = {2.0};
  // In each record: after one below 3 of 5 exceed (1>3, 1>1, 1>3, 1>1, 1>3); after two below 2 of 2.
  EXPECT_DOUBLE_EQ(exceedance_rates(seen, 2, levels).at(0).rate, 3.0 / 5.0);
  EXPECT_DOUBLE_EQ(exceedance_rates(seen, 3, levels).at(0).rate, 1.0);
}

TEST(acer, rates_of_independent_peaks_are_those_of_their_distribution_in_every_order) {
  std::mt19937_64 generator(3);
  const std::vector<PeakRecord> seen = records(20, 2000, [&] { return rayleigh(generator); });
  const std::vector<double> levels = {1.5, 2.0, 2.5, 3.0};
  for (int order = 1; order <= kAcerOrders; ++order) {
    const std::vector<AcerLevel> rates = exceedance_rates(seen, order, levels);
    ASSERT_EQ(rates.size(), levels.size());
    for (const AcerLevel& acer_level : rates) {
      const double truth = std::exp(-0.5 * acer_level.level * acer_level.level);
      EXPECT_NEAR(acer_level.rate, truth, 1.5 * (acer_level.high - acer_level.rate))
          << order << " " << acer_level.level;
    }
  }
}

TEST(acer, finds_the_most_probable_largest_of_a_narrow_band_process) {
  std::mt19937_64 generator(3);
  const auto fit = fit_acer(records(20, 1000, [&] { return rayleigh(generator); }), kReference);
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->order, 1);
  EXPECT_NEAR(fit->expected_peaks, kPeaks, 1e-9);
  EXPECT_NEAR(fit->estimate.value, std::sqrt(2.0 * std::log(kPeaks)), 0.06);
  EXPECT_LT(fit->estimate.low, fit->estimate.value);
  EXPECT_GT(fit->estimate.high, fit->estimate.value);
}

TEST(acer, finds_the_most_probable_largest_of_gumbel_distributed_peaks) {
  std::mt19937_64 generator(3);
  const auto fit =
      fit_acer(records(20, 1000, [&] { return 50.0 - 4.0 * std::log(-std::log(uniform(generator))); }), kReference);
  ASSERT_TRUE(fit);
  // The mode of the largest of n Gumbel variables is mode + scale ln n.
  EXPECT_NEAR(fit->estimate.value, 50.0 + 4.0 * std::log(kPeaks), 1.0);
}

TEST(acer, an_order_above_one_accounts_for_groups_of_high_peaks) {
  // 20,000 simulated records of 1,000 such peaks: their largest stays below 3.633 with probability 1/e, against 3.717
  // for independent peaks.
  const auto fit = fit_acer(records(40, 2000, Groups{std::mt19937_64(4)}), kReference);
  ASSERT_TRUE(fit);
  EXPECT_GT(fit->order, 1);
  EXPECT_NEAR(fit->estimate.value, 3.633, 0.07);
  EXPECT_LT(fit->estimate.value, std::sqrt(2.0 * std::log(kPeaks)));
}

TEST(acer, nine_of_ten_intervals_hold_the_truth) {
  int inside = 0;
  constexpr int kTrials = 60;
  std::mt19937_64 generator(11);
  for (int trial = 0; trial < kTrials; ++trial) {
    const auto fit = fit_acer(records(5, 150, [&] { return rayleigh(generator); }), kReference);
    ASSERT_TRUE(fit);
    const double truth = std::sqrt(2.0 * std::log(kPeaks));
    if (fit->estimate.low <= truth && truth <= fit->estimate.high) ++inside;
  }
  EXPECT_GE(inside, kTrials * 85 / 100);
  EXPECT_LT(inside, kTrials);  // they are not merely wide
}

TEST(acer, does_not_depend_on_where_values_are_counted_from_nor_on_their_unit) {
  std::mt19937_64 first(5), second(5);
  const auto plain = fit_acer(records(5, 200, [&] { return rayleigh(first); }), kReference);
  const auto moved = fit_acer(records(5, 200, [&] { return 3e8 + 1e6 * rayleigh(second); }), kReference);
  ASSERT_TRUE(plain && moved);
  EXPECT_NEAR(moved->estimate.value, 3e8 + 1e6 * plain->estimate.value, 2e3);
  EXPECT_NEAR(moved->estimate.high, 3e8 + 1e6 * plain->estimate.high, 2e4);
}

TEST(acer, smallest_values_are_largest_ones_turned) {
  std::mt19937_64 generator(6);
  const std::vector<PeakRecord> turned = records(5, 200, [&] { return rayleigh(generator); });
  const auto max_value = fit_acer(turned, kReference), min_value = fit_acer_minimum(turned, kReference);
  ASSERT_TRUE(max_value && min_value);
  EXPECT_EQ(min_value->estimate.value, -max_value->estimate.value);
  EXPECT_EQ(min_value->estimate.low, -max_value->estimate.high);
  EXPECT_EQ(min_value->observed, -max_value->observed);
}

TEST(acer, too_few_or_equal_peaks_are_not_fitted) {
  std::mt19937_64 generator(7);
  EXPECT_FALSE(fit_acer(records(3, 99, [&] { return rayleigh(generator); }), kReference));
  EXPECT_FALSE(fit_acer(records(5, 200, [] { return 3.0; }), kReference));
  EXPECT_FALSE(fit_acer({}, kReference));
}

}  // namespace
}  // namespace overbend
