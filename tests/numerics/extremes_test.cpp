#include "numerics/extremes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "base/constants.h"

namespace overbend {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;

/// Gaussian record of unit deviation about 10, frequencies about 0.1 Hz spread by 0.015 Hz, three hours by 0.5 s.
std::vector<double> narrow_band(std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> frequency(0.1, 0.015);
  std::uniform_real_distribution<double> phase(0.0, kTwoPi);
  constexpr int kComponents = 200;
  std::vector<double> values(21600, 10.0);
  for (int c = 0; c < kComponents; ++c) {
    const double turn = kTwoPi * frequency(generator) * 0.5;
    const double start = phase(generator);
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] += std::sqrt(2.0 / kComponents) * std::cos(turn * static_cast<double>(i) + start);
    }
  }
  return values;
}

std::vector<double> weibull_sample(std::size_t count, double scale, double shape, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  std::weibull_distribution<double> weibull(shape, scale);
  std::vector<double> peaks(count);
  std::generate(peaks.begin(), peaks.end(), [&] { return weibull(generator); });
  return peaks;
}

std::vector<double> gumbel_sample(std::size_t count, double mode, double scale, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  std::exponential_distribution<double> exponential;
  std::vector<double> peaks(count);
  std::generate(peaks.begin(), peaks.end(), [&] { return mode - scale * std::log(exponential(generator)); });
  return peaks;
}

TEST(extremes, peaks_are_the_largest_between_up_crossings_of_the_mean) {
  const std::vector<double> values{3.0, -1.0, 2.0, 5.0, 1.0, -2.0, -4.0, 1.0, 0.5, -0.5, 7.0, -12.0};  // mean 0
  const RecordPeaks record = peaks_between_up_crossings(values);
  EXPECT_NEAR(record.mean, 0.0, 1e-15);
  EXPECT_EQ(record.peaks, (std::vector<double>{5.0, 1.0}));  // what is open at either end does not count
  EXPECT_EQ(record.steps, 8.0);                              // from the third value to the eleventh
}

TEST(extremes, of_a_narrow_band_record_are_those_of_rayleigh_peaks) {
  constexpr int kRecords = 16;
  double weibull = 0.0, gumbel = 0.0, shape = 0.0, exact = 0.0;
  int held = 0;
  for (std::uint64_t seed = 1; seed <= kRecords; ++seed) {
    const ExtremeFit fit = fit_extremes(narrow_band(seed), 0.5, kThreeHours);
    ASSERT_TRUE(fit.enough);
    EXPECT_NEAR(fit.peaks, 1080, 40);
    const double rayleigh = 10.0 + std::sqrt(2.0 * std::log(fit.peaks));
    EXPECT_NEAR(fit.weibull.value, rayleigh, 0.2 * (rayleigh - 10.0));
    held += fit.weibull.low <= rayleigh && rayleigh <= fit.weibull.high;
    weibull += (fit.weibull.value - 10.0) / kRecords;
    gumbel += (fit.gumbel.value - 10.0) / kRecords;
    shape += fit.weibull_shape / kRecords;
    exact += (rayleigh - 10.0) / kRecords;
  }
  EXPECT_NEAR(weibull, exact, 0.03 * exact);  // one record scatters by 3 %
  EXPECT_NEAR(shape, 2.0, 0.1);
  EXPECT_NEAR(gumbel, exact, 0.08 * exact);  // a Gumbel tail is heavier than a Rayleigh one: it errs upwards
  EXPECT_GE(held, kRecords * 3 / 4);         // waves come in groups, so intervals for independent peaks are narrow
}

TEST(extremes, weibull_peaks_give_their_parameters_and_their_extreme_back) {
  const double scale = 2.5, shape = 1.4;
  const std::vector<double> peaks = weibull_sample(4000, scale, shape, 5);
  const ExtremeFit fit = fit_peaks(peaks, 0.0, 4000.0);
  // Standard errors in the upper half of n: 1.06/sqrt(n) of the shape, 1.16/(shape sqrt(n)) of the scale, 1.97/(shape
  // sqrt(n)) of the extreme, each relative; four of them.
  EXPECT_NEAR(fit.weibull_shape, shape, 0.067 * shape);
  EXPECT_NEAR(fit.weibull_scale, scale, 0.052 * scale);
  const double truth = scale * std::pow(std::log(4000.0), 1.0 / shape);
  EXPECT_NEAR(fit.weibull.value, truth, 0.089 * truth);
}

TEST(extremes, blocks_of_gumbel_peaks_give_their_parameters_back) {
  const double mode = 20.0, scale = 3.0;
  const std::vector<double> peaks = gumbel_sample(40000, mode, scale, 6);
  const ExtremeFit fit = fit_peaks(peaks, 0.0, 40000.0);
  ASSERT_EQ(fit.peaks_per_block, 200);
  // 200 blocks: standard errors of 0.055 and 0.074 scales
  EXPECT_NEAR(fit.gumbel_mode, mode + scale * std::log(200.0), 4.0 * 0.074 * scale);
  EXPECT_NEAR(fit.gumbel_scale, scale, 4.0 * 0.055 * scale);
}

TEST(extremes, intervals_hold_the_truth_in_95_of_100_records) {
  int weibull = 0, gumbel = 0;
  const double wanted = 500.0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const ExtremeFit of_weibull = fit_peaks(weibull_sample(60, 2.0, 2.0, seed), 0.0, wanted);
    const double weibull_truth = 2.0 * std::sqrt(std::log(wanted));
    weibull += of_weibull.weibull.low <= weibull_truth && weibull_truth <= of_weibull.weibull.high;
    const ExtremeFit of_gumbel = fit_peaks(gumbel_sample(60, 7.0, 0.5, seed), 0.0, wanted);
    const double gumbel_truth = 7.0 + 0.5 * std::log(wanted);
    gumbel += of_gumbel.gumbel.low <= gumbel_truth && gumbel_truth <= of_gumbel.gumbel.high;
  }
  for (const int held : {weibull, gumbel}) {
    EXPECT_GE(held, 178);  // 190 +- four binomial deviations of 3
    EXPECT_LE(held, 199);
  }
}

TEST(extremes, ripples_about_the_mean_do_not_bend_the_weibull_tail) {
  std::vector<double> peaks = weibull_sample(1000, 2.0, 2.0, 8);
  const double clean = fit_peaks(peaks, 0.0, 1000.0).weibull.value;
  std::sort(peaks.begin(), peaks.end());
  for (std::size_t i = 0; i < 300; ++i) {
    peaks[i] *= 1e-3;
  }
  EXPECT_EQ(fit_peaks(peaks, 0.0, 1000.0).weibull.value, clean);
}

TEST(extremes, smallest_is_the_largest_of_the_turned_record) {
  const std::vector<double> values = narrow_band(77);
  std::vector<double> turned(values);
  for (double& value : turned) {
    value = -value;
  }
  const ExtremeFit min_value = fit_minimum(values, 0.5, kThreeHours);
  const ExtremeFit max_value = fit_extremes(turned, 0.5, kThreeHours);
  EXPECT_EQ(min_value.weibull.value, -max_value.weibull.value);
  EXPECT_EQ(min_value.observed, *std::min_element(values.begin(), values.end()));
  EXPECT_LT(min_value.gumbel.low, min_value.gumbel.value);
  EXPECT_GT(min_value.gumbel.high, min_value.gumbel.value);
}

TEST(extremes, few_peaks_are_not_fitted) {
  for (const std::size_t count : {0u, 1u, 29u}) {
    const std::vector<double> peaks = weibull_sample(count, 2.0, 2.0, 9);
    const ExtremeFit fit = fit_peaks(peaks, 0.0, 1000.0);
    EXPECT_FALSE(fit.enough);
    EXPECT_EQ(fit.weibull.value, fit.observed);
    EXPECT_EQ(fit.gumbel.high, fit.observed);
  }
  EXPECT_TRUE(fit_peaks(weibull_sample(30, 2.0, 2.0, 9), 0.0, 1000.0).enough);
  const std::vector<double> constant(1000, 4.0), rising{1.0, 2.0, 3.0};
  EXPECT_EQ(fit_extremes(constant, 0.5, kThreeHours).gumbel.value, 4.0);
  EXPECT_EQ(fit_extremes(rising, 0.5, kThreeHours).weibull.value, 3.0);
  EXPECT_FALSE(fit_extremes({}, 0.5, kThreeHours).enough);
}

TEST(extremes, of_a_regular_wave_are_its_crest) {
  std::vector<double> values(20000);
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = 2.0 * std::sin(kTwoPi * static_cast<double>(i % 20) / 20.0);
  }
  const ExtremeFit fit = fit_extremes(values, 0.5, kThreeHours);
  EXPECT_TRUE(fit.enough);
  EXPECT_NEAR(fit.weibull.value, 2.0, 1e-9);
  EXPECT_NEAR(fit.gumbel.high, 2.0, 1e-9);
}

/// Light loads with a rare impact: exponential peaks of mean 1, one in `every` of an exponential impact of mean 8
/// beyond 4, and rest between them.
std::vector<double> light_with_impacts(double hours, int every, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  std::exponential_distribution<double> light(1.0), impact(1.0 / 8.0);
  std::uniform_int_distribution<int> which(1, every);
  std::vector<double> values;
  for (int cycle = 0; cycle < static_cast<int>(hours * 360.0); ++cycle) {  // of 10 s
    const double peak = which(generator) == 1 ? 4.0 + impact(generator) : light(generator);
    values.insert(values.end(), {0.0, 0.0, 0.3 * peak, peak, 0.4 * peak, 0.0, 0.0, 0.0, 0.0, 0.0});
  }
  return values;
}

/// Level that `per_cycle` of the impacts exceed once in three hours.
double impact_of_three_hours(int every) {
  return 4.0 + 8.0 * std::log(1080.0 / every);
}

TEST(extremes, of_rare_impacts_are_not_reported_by_a_short_record) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const ExtremeFit fit = fit_extremes(light_with_impacts(0.25, 100, seed), 1.0, kThreeHours);
    EXPECT_EQ(fit.method, ExtremeMethod::none);
    EXPECT_EQ(fit.quality, ExtremeQuality::none);
    EXPECT_EQ(fit.doubt, ExtremeDoubt::rare);
    EXPECT_EQ(fit.estimate.value, fit.observed);
  }
}

TEST(extremes, of_rare_impacts_are_near_the_truth_in_three_hours) {
  double error = 0.0;
  int held = 0;
  constexpr int kRecords = 40;
  for (const int every : {20, 100}) {
    const double truth = impact_of_three_hours(every);
    for (std::uint64_t seed = 1; seed <= kRecords / 2; ++seed) {
      const ExtremeFit fit = fit_extremes(light_with_impacts(3.0, every, seed), 1.0, kThreeHours);
      EXPECT_EQ(fit.quality, ExtremeQuality::uncertain);
      EXPECT_EQ(fit.doubt, ExtremeDoubt::rare);
      EXPECT_GE(fit.estimate.value, fit.observed);
      error += (fit.estimate.value / truth - 1.0) / kRecords;
      held += fit.estimate.low <= truth && truth <= fit.estimate.high;
    }
  }
  // Not low on average; the largest of three hours, which no estimate is below, is higher by 0.577 of the mean of 8.
  EXPECT_GT(error, 0.0);
  EXPECT_LT(error, 0.4);
  EXPECT_GE(held, kRecords * 7 / 10);
}

TEST(extremes, of_a_regular_motion_are_its_crest_though_rows_meet_it_here_and_there) {
  std::vector<double> values;
  for (int i = 0; i < 20000; ++i) values.push_back(std::sin(2.0 * std::numbers::pi * i * 0.5 / 7.3));
  const ExtremeFit fit = fit_extremes(values, 0.5, kThreeHours);
  EXPECT_EQ(fit.method, ExtremeMethod::regular);
  EXPECT_EQ(fit.quality, ExtremeQuality::good);
  EXPECT_NEAR(fit.estimate.value, 1.0, 1e-3);
}

TEST(extremes, of_weibull_peaks_are_weibulls_in_19_of_20_records) {
  int weibull = 0, good = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const ExtremeFit fit = fit_peaks(weibull_sample(180, 2.0, 2.0, seed), 0.0, 1080.0);
    weibull += fit.method == ExtremeMethod::weibull;
    good += fit.quality == ExtremeQuality::good;
    EXPECT_GE(fit.estimate.value, fit.observed);  // of a sixth of the time
    EXPECT_NEAR(fit.estimate.value, 2.0 * std::sqrt(std::log(1080.0)), 2.5);
  }
  EXPECT_GE(weibull, 186);
  EXPECT_GE(good, 170);
}

TEST(extremes, of_peaks_with_a_heavy_tail_are_not_those_of_most_of_them) {
  double error = 0.0;
  constexpr int kRecords = 20;
  const double truth = 10.0 + 8.0 * std::log(1080.0 / 30.0);
  for (std::uint64_t seed = 1; seed <= kRecords; ++seed) {  // on a quantity that never rests
    std::mt19937_64 generator(seed);
    std::normal_distribution<double> max_magnitude(5.0, 1.0);
    std::exponential_distribution<double> impact(1.0 / 8.0);
    std::vector<double> peaks;
    for (int i = 0; i < 1080; ++i) peaks.push_back(i % 30 == 7 ? 10.0 + impact(generator) : max_magnitude(generator));
    const ExtremeFit fit = fit_peaks(peaks, 4.0, 1080.0);
    EXPECT_EQ(fit.method, ExtremeMethod::pareto);
    EXPECT_FALSE(fit.weibull_describes);
    error += (fit.estimate.value / truth - 1.0) / kRecords;
  }
  EXPECT_NEAR(error, 0.0, 0.1);
}

TEST(extremes, rest_of_a_record_is_the_share_of_cycles_that_come_down_to_its_least_value) {
  EXPECT_GT(peaks_between_up_crossings(light_with_impacts(1.0, 50, 1)).fraction_at_minimum, 0.99);
  EXPECT_LT(peaks_between_up_crossings(narrow_band(3)).fraction_at_minimum, 0.01);
}

TEST(extremes, are_the_same_each_time) {
  const std::vector<double> peaks = weibull_sample(50, 2.0, 2.0, 10);
  const ExtremeFit first = fit_peaks(peaks, 0.0, 700.0), second = fit_peaks(peaks, 0.0, 700.0);
  EXPECT_EQ(first.weibull.low, second.weibull.low);
  EXPECT_EQ(first.gumbel.high, second.gumbel.high);
}

}  // namespace
}  // namespace overbend
