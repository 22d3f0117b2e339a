#include "checks/fatigue_curve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>

#include "numerics/rainflow.h"

namespace overbend {
namespace {

constexpr double kMPa = 1e6;

double life(const SnCurve& curve, double megapascal) {
  return 1.0 / curve.damage(megapascal * kMPa);
}

/// Five digits were computed from the tables.
TEST(fatigue_curve, lives_are_those_computed_from_the_tables) {
  const SnCurve d = sn_curve(FatigueCurve::d, FatigueMedium::air);
  EXPECT_NEAR(d.knee / kMPa, 52.60, 0.005);
  EXPECT_NEAR(life(d, 20.0) / 1.2614e9, 1.0, 5e-5);
  EXPECT_NEAR(life(d, 50.0) / 1.2917e7, 1.0, 5e-5);
  EXPECT_NEAR(life(d, 100.0) / 1.4588e6, 1.0, 5e-5);
  EXPECT_NEAR(life(d, 200.0) / 1.8235e5, 1.0, 5e-5);
  const SnCurve f1 = sn_curve(FatigueCurve::f1, FatigueMedium::air);
  EXPECT_NEAR(f1.knee / kMPa, 36.86, 0.005);
  EXPECT_NEAR(life(f1, 50.0) / 4.0003e6, 1.0, 5e-5);
  EXPECT_NEAR(life(f1, 100.0) / 5.0003e5, 1.0, 5e-5);
  const SnCurve water = sn_curve(FatigueCurve::d, FatigueMedium::seawater_protected);
  EXPECT_NEAR(water.knee / kMPa, 83.37, 0.005);
  EXPECT_NEAR(life(water, 100.0) / 5.8076e5, 1.0, 5e-5);
  const SnCurve e = sn_curve(FatigueCurve::e, FatigueMedium::air);
  EXPECT_NEAR(life(e, 50.0) / 8.1863e6, 1.0, 5e-5);
  EXPECT_NEAR(life(e, 100.0) / 1.0233e6, 1.0, 5e-5);
}

/// The tables say that the slope changes at 10^7 cycles in air and 10^6 in seawater; their three decimals of log a
/// leave that life to 2 %.
TEST(fatigue_curve, every_curve_is_continuous_where_the_tables_change_its_slope) {
  for (int i = 0; i < 14; ++i) {
    for (const FatigueMedium medium : {FatigueMedium::air, FatigueMedium::seawater_protected}) {
      const SnCurve curve = sn_curve(static_cast<FatigueCurve>(i), medium);
      EXPECT_NEAR(curve.damage(curve.knee * (1.0 - 1e-9)) / curve.damage(curve.knee), 1.0, 1e-7) << i;
      const double expected = medium == FatigueMedium::air ? 1e7 : 1e6;
      EXPECT_NEAR(1.0 / curve.damage(curve.knee) / expected, 1.0, 0.02) << i;
    }
  }
}

/// Ranges that the package pythagoras has for the change of slope in air, in MPa.
TEST(fatigue_curve, ranges_at_ten_million_cycles_in_air_are_those_of_a_public_package) {
  constexpr std::array kRanges = {106.97, 93.59, 73.10, 65.50, 58.48, 52.63, 46.78,
                                  41.52,  36.84, 32.75, 29.24, 26.32, 23.39, 21.05};
  for (std::size_t i = 0; i < kRanges.size(); ++i) {
    const SnCurve curve = sn_curve(static_cast<FatigueCurve>(i), FatigueMedium::air);
    EXPECT_NEAR(curve.find_range(1e-7) / kMPa, kRanges[i], 1e-3 * kRanges[i]) << i;
  }
}

/// Life by the edition of 2016 over that by the edition of 2024, whose constants are those of NREL, pCrunch: worked out
/// apart, to two decimals.
TEST(fatigue_curve, editions_differ_for_c_c1_and_c2_by_what_their_constants_say) {
  const auto lives = [](FatigueCurve curve, FatigueMedium medium, double megapascal) {
    return life(sn_curve(curve, medium, FatigueEdition::year_2016), megapascal) /
           life(sn_curve(curve, medium, FatigueEdition::year_2024), megapascal);
  };
  const FatigueMedium air = FatigueMedium::air, water = FatigueMedium::seawater_protected;
  EXPECT_NEAR(lives(FatigueCurve::c, air, 60.0), 0.51, 0.005);
  EXPECT_NEAR(lives(FatigueCurve::c, air, 90.0), 0.77, 0.005);
  EXPECT_NEAR(lives(FatigueCurve::c, air, 150.0), 1.10, 0.005);
  EXPECT_NEAR(lives(FatigueCurve::c, air, 200.0), 1.27, 0.005);
  EXPECT_NEAR(lives(FatigueCurve::c, air, 300.0), 1.55, 0.005);
  EXPECT_NEAR(lives(FatigueCurve::c1, air, 200.0), 1.34, 0.005);
  EXPECT_NEAR(lives(FatigueCurve::c1, air, 300.0), 1.64, 0.005);
  EXPECT_NEAR(lives(FatigueCurve::c2, air, 200.0), 1.41, 0.005);
  EXPECT_NEAR(lives(FatigueCurve::c2, air, 300.0), 1.73, 0.005);
  EXPECT_NEAR(lives(FatigueCurve::c, water, 300.0), 1.00, 0.005);
  EXPECT_NEAR(lives(FatigueCurve::c2, water, 300.0), 1.12, 0.005);
  EXPECT_LT(lives(FatigueCurve::b1, water, 200.0), 1.0);
  EXPECT_EQ(lives(FatigueCurve::b1, air, 200.0), 1.0);
  for (const FatigueCurve curve : {FatigueCurve::d, FatigueCurve::e, FatigueCurve::f1, FatigueCurve::w3}) {
    EXPECT_EQ(lives(curve, air, 200.0), 1.0);
    EXPECT_EQ(lives(curve, water, 20.0), 1.0);
  }
}

TEST(fatigue_curve, the_curves_of_2024_change_slope_at_five_million_cycles_in_air_and_a_million_in_water) {
  for (const FatigueCurve curve : {FatigueCurve::c, FatigueCurve::c1, FatigueCurve::c2}) {
    const SnCurve air = sn_curve(curve, FatigueMedium::air, FatigueEdition::year_2024);
    const SnCurve water = sn_curve(curve, FatigueMedium::seawater_protected, FatigueEdition::year_2024);
    EXPECT_NEAR(1.0 / air.damage(air.knee) / 5e6, 1.0, 0.02);  // three decimals of log a
    EXPECT_NEAR(1.0 / water.damage(water.knee) / 1e6, 1.0, 0.02);
  }
  for (const FatigueCurve curve : {FatigueCurve::b1, FatigueCurve::b2}) {
    const SnCurve water = sn_curve(curve, FatigueMedium::seawater_protected, FatigueEdition::year_2024);
    EXPECT_NEAR(1.0 / water.damage(water.knee) / 1e6, 1.0, 0.02);
  }
}

/// At 40 mm: (40/25)^0.05 and the (40/25)^0.15 of the editions with the larger exponent, which goes with 2024.
TEST(fatigue_curve, the_larger_thickness_exponent_goes_with_the_edition_for_which_none_is_known) {
  const SnCurve old = sn_curve(FatigueCurve::c, FatigueMedium::air, FatigueEdition::year_2016);
  const SnCurve renewed = sn_curve(FatigueCurve::c, FatigueMedium::air, FatigueEdition::year_2024);
  EXPECT_NEAR(thickness_effect(old, 0.040), 1.024, 0.0005);
  EXPECT_NEAR(thickness_effect(renewed, 0.040), 1.073, 0.0005);
}

TEST(fatigue_curve, free_corrosion_has_one_slope_and_is_the_worst) {
  for (int i = 0; i < 14; ++i) {
    const SnCurve free = sn_curve(static_cast<FatigueCurve>(i), FatigueMedium::seawater_free);
    EXPECT_NEAR(free.damage(2.0 * kMPa) / free.damage(1.0 * kMPa), 8.0, 1e-9);
    const SnCurve held = sn_curve(static_cast<FatigueCurve>(i), FatigueMedium::seawater_protected);
    for (const double range : {5.0, 50.0, 100.0}) EXPECT_GT(free.damage(range * kMPa), held.damage(range * kMPa)) << i;
  }
}

TEST(fatigue_curve, the_range_of_a_damage_is_the_range_that_does_it) {
  for (const FatigueMedium medium :
       {FatigueMedium::air, FatigueMedium::seawater_protected, FatigueMedium::seawater_free}) {
    const SnCurve curve = sn_curve(FatigueCurve::c1, medium);
    for (const double range : {0.3, 20.0, 80.0, 400.0}) {
      EXPECT_NEAR(curve.find_range(curve.damage(range * kMPa)) / kMPa, range, 1e-9 * range);
    }
    EXPECT_EQ(curve.damage(0.0), 0.0);
    EXPECT_EQ(curve.find_range(0.0), 0.0);
  }
}

TEST(fatigue_curve, the_wall_counts_beyond_25_mm_only) {
  const SnCurve d = sn_curve(FatigueCurve::d, FatigueMedium::air);
  EXPECT_EQ(thickness_effect(d, 0.0127), 1.0);
  EXPECT_EQ(thickness_effect(d, 0.025), 1.0);
  EXPECT_NEAR(thickness_effect(d, 0.050), std::pow(2.0, 0.2), 1e-12);
  EXPECT_EQ(thickness_effect(sn_curve(FatigueCurve::b1, FatigueMedium::air), 0.050), 1.0);
}

TEST(fatigue_curve, hi_lo_of_a_flat_plate_bends_it_by_three_times_its_eccentricity) {
  EXPECT_EQ(hi_lo_factor(0.0, 0.3239, 0.0127), 1.0);
  EXPECT_NEAR(hi_lo_factor(0.002, 1e9, 0.020), 1.3, 1e-5);
  // By hand for 323.9 x 12.7 mm with 1.5 mm: 0.354331 exp(-0.198014).
  EXPECT_NEAR(hi_lo_factor(0.0015, 0.3239, 0.0127), 1.290678, 1e-6);
}

/// The package pythagoras has the newer formula of a transition in thickness, of which this is the form for equal
/// walls: misalignment of 1 mm, a transition as long as the wall.
TEST(fatigue_curve, hi_lo_lies_within_half_a_per_cent_of_the_newer_formula) {
  EXPECT_NEAR(hi_lo_factor(0.001, 0.4064, 0.011125) / 1.2320, 1.0, 5e-3);
  EXPECT_NEAR(hi_lo_factor(0.001, 0.32385, 0.0206) / 1.1158, 1.0, 5e-3);
}

/// Lower incomplete gamma function by its series.
double lower_gamma(double a, double x) {
  double term = 1.0 / a, sum = term;
  for (int n = 1; n < 200; ++n) {
    term *= x / (a + n);
    sum += term;
  }
  return sum * std::exp(-x + a * std::log(x));
}

/// Mean damage of a cycle of narrow-band Gaussian stress: ranges are twice Rayleigh amplitudes.
double narrow_band_damage(const SnCurve& curve, double deviation) {
  const double scale = 2.0 * std::numbers::sqrt2 * deviation / kMPa;
  const double above = 1.0 + 0.5 * curve.slope, below = 1.0 + 0.5 * curve.slope_below;
  const double large = std::pow(scale, curve.slope) * std::pow(10.0, -curve.log_a);
  if (curve.knee <= 0.0) return large * std::tgamma(above);
  const double x = std::pow(curve.knee / kMPa / scale, 2);
  return large * (std::tgamma(above) - lower_gamma(above, x)) +
         std::pow(scale, curve.slope_below) * std::pow(10.0, -curve.log_a_below) * lower_gamma(below, x);
}

/// Slowly changing amplitudes and phases, one for each cycle, of a Gaussian process. Their amplitudes are put to the
/// quantiles of the Rayleigh distribution, in the order that they have, so that no chance of few large ones is left.
std::vector<std::complex<double>> slow_amplitudes(std::size_t cycles) {
  constexpr double kAlike = 0.998;  ///< From one cycle to the next.
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  std::vector<std::complex<double>> out = {{normal(random), normal(random)}};
  while (out.size() < cycles) {
    out.push_back(kAlike * out.back() +
                  std::sqrt(1.0 - kAlike * kAlike) * std::complex<double>(normal(random), normal(random)));
  }
  std::vector<std::size_t> order(cycles);
  for (std::size_t i = 0; i < cycles; ++i) order[i] = i;
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return std::abs(out[a]) < std::abs(out[b]); });
  for (std::size_t rank = 0; rank < cycles; ++rank) {
    const double below = (static_cast<double>(rank) + 0.5) / static_cast<double>(cycles);
    out[order[rank]] *= std::sqrt(-2.0 * std::log(1.0 - below)) / std::abs(out[order[rank]]);
  }
  return out;
}

/// Ranges of the record of unit deviation that these amplitudes make, with their counts.
std::vector<RainflowCycle> counted(const std::vector<std::complex<double>>& amplitudes) {
  constexpr int kSamples = 40;  ///< Samples of a cycle: its peak is met to 0.1 % in the mean.
  std::vector<RainflowCycle> cycles;
  const auto keep = [&](std::size_t, const RainflowCycle& cycle) { cycles.push_back(cycle); };
  RainflowCounter counter(1);
  for (std::size_t i = 0; i + 1 < amplitudes.size(); ++i) {
    for (int sample = 0; sample < kSamples; ++sample) {
      const double part = static_cast<double>(sample) / kSamples;
      const std::complex<double> current = amplitudes[i] + part * (amplitudes[i + 1] - amplitudes[i]);
      const double value = (current * std::polar(1.0, 2.0 * std::numbers::pi * part)).real();
      counter.add(std::span(&value, 1), keep);
    }
  }
  counter.residue(keep);
  return cycles;
}

TEST(fatigue_curve, narrow_band_gaussian_stress_does_the_damage_of_the_closed_form_within_two_per_cent) {
  const std::vector<std::complex<double>> amplitudes = slow_amplitudes(20000);
  const std::vector<RainflowCycle> cycles = counted(amplitudes);
  for (const FatigueMedium medium :
       {FatigueMedium::air, FatigueMedium::seawater_protected, FatigueMedium::seawater_free}) {
    const SnCurve curve = sn_curve(FatigueCurve::d, medium);
    for (const double deviation : {5.0 * kMPa, 20.0 * kMPa, 60.0 * kMPa}) {
      double damage = 0.0;
      for (const RainflowCycle& cycle : cycles) damage += cycle.count * curve.damage(cycle.range * deviation);
      const double mean = damage / static_cast<double>(amplitudes.size() - 1);
      const double error = mean / narrow_band_damage(curve, deviation) - 1.0;
      EXPECT_NEAR(error, 0.0, 0.02) << deviation << " " << static_cast<int>(medium);
    }
  }
}

}  // namespace
}  // namespace overbend
