#include "mechanics/wave_spectrum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "base/constants.h"
#include "mechanics/sea.h"

namespace overbend {
namespace {

WavesDescription wind_sea(WaveType type, double hs, double tp) {
  WavesDescription waves;
  waves.type = type;
  waves.hs = hs;
  waves.tp = tp;
  return waves;
}

/// Integral of omega^n S(omega) by the midpoint rule, in the fine steps that an error below 1e-6 wants.
double moment(const WaveSpectrum& spectrum, int n, double from, double to) {
  constexpr int kSteps = 200000;
  const double width = (to - from) / kSteps;
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double omega = from + width * (i + 0.5);
    sum += std::pow(omega, n) * spectrum.density(omega) * width;
  }
  return sum;
}

TEST(jonswap_gamma, follows_the_rule_of_the_sea_state) {
  EXPECT_EQ(jonswap_gamma(4.0, 7.0), 5.0);  // Tp/sqrt(Hs) = 3.5
  EXPECT_NEAR(jonswap_gamma(4.0, 8.0), std::exp(1.15), 1e-12);
  EXPECT_NEAR(jonswap_gamma(4.0, 9.0), std::exp(0.575), 1e-12);
  EXPECT_EQ(jonswap_gamma(4.0, 10.0), 1.0);
  EXPECT_EQ(jonswap_gamma(4.0, 12.9), 1.0);
  EXPECT_NEAR(jonswap_gamma(1.0, 3.6 + 1e-9), 5.0, 0.03);  // exp(1.61) = 5.003: the rule all but joins
  EXPECT_NEAR(jonswap_gamma(1.0, 5.0 - 1e-9), 1.0, 1e-8);
}

TEST(wave_spectrum, pierson_moskowitz_is_the_published_formula) {
  const WaveSpectrum spectrum(wind_sea(WaveType::pierson_moskowitz, 3.0, 11.0));
  const double peak = 2.0 * kPi / 11.0;
  for (const double x : {0.6, 1.0, 1.3, 3.0, 8.0}) {
    const double omega = x * peak;
    const double published =
        5.0 / 16.0 * 9.0 * std::pow(peak, 4) * std::pow(omega, -5) * std::exp(-1.25 * std::pow(omega / peak, -4));
    EXPECT_NEAR(spectrum.density(omega) / published, 1.0, 1e-8);
  }
}

TEST(wave_spectrum, every_wind_sea_holds_its_height) {
  for (const double gamma : {1.0, 2.0, 3.3, 7.0, 10.0}) {
    WavesDescription waves = wind_sea(WaveType::jonswap, 4.0, 8.0);
    waves.gamma = gamma;
    const WaveSpectrum spectrum(waves);
    const double peak = 2.0 * kPi / 8.0;
    // Beyond 60 peak frequencies lie 1.25/60^4 = 1e-7 of the variance.
    EXPECT_NEAR(moment(spectrum, 0, 0.0, 60.0 * peak), 1.0, 2e-6) << gamma;
    EXPECT_EQ(spectrum.variance(), 1.0);
    EXPECT_GT(spectrum.share_inside(), 0.995);
    EXPECT_NEAR(moment(spectrum, 0, 0.4 * peak, 5.0 * peak), spectrum.share_inside(), 1e-6);
  }
}

TEST(wave_spectrum, jonswap_is_close_to_the_usual_closed_normalisation) {
  WavesDescription waves = wind_sea(WaveType::jonswap, 4.0, 8.0);
  const double base = WaveSpectrum(wind_sea(WaveType::pierson_moskowitz, 4.0, 8.0)).density(2.0 * kPi / 8.0);
  for (const double gamma : {1.5, 3.3, 5.0, 7.0}) {
    waves.gamma = gamma;
    const double closed = (1.0 - 0.287 * std::log(gamma)) * gamma * base;  // at the peak
    EXPECT_NEAR(spectral_density(waves, 2.0 * kPi / 8.0) / closed, 1.0, 0.02) << gamma;
  }
}

TEST(wave_spectrum, the_peak_lies_at_the_peak_period_and_is_gamma_high) {
  WavesDescription waves = wind_sea(WaveType::jonswap, 4.0, 8.0);
  waves.gamma = 4.0;
  const WaveSpectrum spectrum(waves);
  const double peak = 2.0 * kPi / 8.0, at_peak = spectrum.density(peak);
  for (const double off : {-0.02, -0.001, 0.001, 0.02}) EXPECT_LT(spectrum.density((1.0 + off) * peak), at_peak);
  // The enhancement one width sigma off the peak, 0.07 below and 0.09 above, is gamma^exp(-1/2).
  const WaveSpectrum plain(wind_sea(WaveType::pierson_moskowitz, 4.0, 8.0));
  const double ratio = at_peak / plain.density(peak) / 4.0;
  for (const double x : {0.93, 1.09}) {
    EXPECT_NEAR(spectrum.density(x * peak) / plain.density(x * peak) / ratio, std::pow(4.0, std::exp(-0.5)), 1e-9);
  }
}

TEST(wave_spectrum, the_height_alone_follows_the_rule_for_gamma) {
  WavesDescription ruled = wind_sea(WaveType::jonswap, 4.0, 8.5), given = ruled;
  given.gamma = jonswap_gamma(4.0, 8.5);
  EXPECT_EQ(spectral_density(ruled, 0.8), spectral_density(given, 0.8));
  EXPECT_GT(*given.gamma, 2.0);
}

TEST(wave_spectrum, quantiles_are_where_the_energy_is) {
  const WaveSpectrum spectrum(wind_sea(WaveType::pierson_moskowitz, 3.0, 11.0));
  const double peak = 2.0 * kPi / 11.0, inside = std::exp(-1.25 / 625.0);
  for (const double share : {0.1, 0.5, 0.9, 0.99}) {
    // Its cumulative is exp(-1.25 (peak/omega)^4).
    EXPECT_NEAR(spectrum.quantile(share), peak * std::pow(1.25 / -std::log(share * inside), 0.25), 1e-5 * peak);
  }
  EXPECT_NEAR(spectrum.quantile(0.0), 0.4 * peak, 1e-9);
  EXPECT_NEAR(spectrum.quantile(1.0), 5.0 * peak, 1e-9);
}

TEST(wave_spectrum, a_users_table_is_linear_between_its_points) {
  WavesDescription waves;
  waves.type = WaveType::user;
  waves.spectrum = {{0.4, 0.0}, {0.8, 2.0}, {1.8, 0.0}};
  const WaveSpectrum spectrum(waves);
  EXPECT_DOUBLE_EQ(spectrum.density(0.6), 1.0);
  EXPECT_DOUBLE_EQ(spectrum.density(1.3), 1.0);
  EXPECT_EQ(spectrum.density(0.39), 0.0);
  EXPECT_EQ(spectrum.density(1.81), 0.0);
  EXPECT_EQ(spectrum.density(1.8), 0.0);
  EXPECT_NEAR(spectrum.variance(), 1.4, 1e-12);
  EXPECT_EQ(spectrum.share_inside(), 1.0);
  EXPECT_NEAR(spectrum.quantile(0.4 / 1.4), 0.8, 1e-6);
}

TEST(wave_spectrum, a_table_without_energy_is_rejected) {
  WavesDescription waves;
  waves.type = WaveType::user;
  EXPECT_THROW(WaveSpectrum{waves}, std::invalid_argument);
  waves.spectrum = {{0.4, 0.0}, {0.8, 0.0}};
  EXPECT_THROW(WaveSpectrum{waves}, std::invalid_argument);
  waves.type = WaveType::airy;
  EXPECT_THROW(WaveSpectrum{waves}, std::invalid_argument);
  EXPECT_EQ(spectral_density(waves, 1.0), 0.0);
}

}  // namespace
}  // namespace overbend
