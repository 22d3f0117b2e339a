#include "mechanics/spectral_peaks.h"

#include <algorithm>
#include <cmath>

#include "base/constants.h"

namespace overbend {
namespace {

// Torsethaugen's parameters, named as in the publications.
constexpr double kAf = 6.6;               // [s/m^1/3]
constexpr double kAl = 2.0;               // [s/m^1/2]
constexpr double kAu = 25.0;              // [s]
constexpr double kA10 = 0.7, kA1 = 0.5;   // wind sea's share of Hs
constexpr double kA20 = 0.6, kA2 = 0.3;   // swell's share of Hs
constexpr double kA3 = 6.0;               // growth of gamma of swell
constexpr double kB1 = 2.0;               // [s]
constexpr double kB2 = 0.7, kB3 = 3.0;    // [1], [m]
constexpr double kKg = 35.0;              // gamma
constexpr double kR = 6.0 / 7.0;          // printed as 0.857
constexpr double kKg0 = 3.5, kKg1 = 1.0;  // [1], [m]
constexpr double kK0 = 0.5, kK00 = 3.2;   // exponent n: [1/m^1/2], [1]
constexpr double kM0 = 4.0;               // exponent m
constexpr double kS0 = 0.08, kS1 = 3.0;   // [m2 s], [m]
constexpr double kSimplifiedG0 = 3.26;

/// Returns the factor that gives x^-n exp(-n/m x^-m) a unit integral.
double unit_factor(double n, double m) {
  const double power = (n - 1.0) / m;
  return std::exp(power * std::log(n / m) - std::lgamma(power)) * m;
}

/// Returns the fitted factor that restores the energy of a peak with enhancement gamma.
double enhancement_factor(double gamma, double n, double m) {
  if (gamma <= 1.0) return 1.0;
  const double f1 = 4.1 * std::pow(n - 2.0 * std::pow(m, 0.28) + 5.3, -1.45 * std::pow(m, 0.1) + 0.96);
  const double f2 = (2.2 * std::pow(m, -3.3) + 0.57) * std::pow(n, -0.58 * std::pow(m, 0.37) + 0.53) -
                    1.04 * std::pow(m, -1.9) + 0.94;
  return (1.0 + f1 * std::pow(std::log(gamma), f2)) / gamma;
}

double simplified_enhancement_factor(double gamma) {
  return gamma <= 1.0 ? 1.0 : (1.0 + 1.1 * std::pow(std::log(gamma), 1.19)) / gamma;
}

SpectralPeak make_peak(double hs, double tp, double factor) {
  SpectralPeak peak;
  peak.hs = hs;
  peak.peak = kTurn / tp;
  peak.scale = factor * hs * hs / (16.0 * peak.peak);
  return peak;
}

/// Height, period and peak enhancement of both peaks of a Torsethaugen spectrum.
struct TwoPeaks {
  double hs1 = 0.0, hs2 = 0.0, tp2 = 0.0, gamma1 = 1.0;
  bool wind = true;  ///< The primary peak is that of the wind sea.
};

double steepness_power(double hs, double tp) {
  return std::pow(kTurn / kGravity * hs / (tp * tp), kR);
}

TwoPeaks wind_dominated(double hs, double tp, double tf) {
  const double below = std::clamp((tf - tp) / (tf - kAl * std::sqrt(hs)), 0.0, 1.0) / kA1;
  const double share = (1.0 - kA10) * std::exp(-below * below) + kA10;
  return {share * hs, std::sqrt(1.0 - share * share) * hs, tf + kB1, kKg * steepness_power(share * hs, tp), true};
}

TwoPeaks swell_dominated(double hs, double tp, double tf) {
  const double above = std::clamp((tp - tf) / (kAu - tf), 0.0, 1.0);
  const double share = (1.0 - kA20) * std::exp(-above * above / (kA2 * kA2)) + kA20;
  const double hs2 = std::sqrt(1.0 - share * share) * hs;
  return {share * hs, hs2, kAf * std::cbrt(hs2), kKg * steepness_power(hs, tf) * (1.0 + kA3 * above), false};
}

std::vector<SpectralPeak> simplified_peaks(const TwoPeaks& two, double tp) {
  const double gamma = std::max(1.0, two.gamma1);
  std::vector<SpectralPeak> peaks = {make_peak(two.hs1, tp, kSimplifiedG0 * simplified_enhancement_factor(gamma))};
  if (two.hs2 > 0.0) peaks.push_back(make_peak(two.hs2, two.tp2, kSimplifiedG0));
  for (SpectralPeak& peak : peaks) peak.n = 4.0;
  peaks.front().gamma = gamma;
  return peaks;
}

/// Returns the peak period of the wind sea under swell, from the level of its tail.
double wind_sea_period(double hs, double hs_wind, double n, double factor) {
  const double level = kS0 * (1.0 - std::exp(-hs / kS1));
  return std::pow(factor * hs_wind * hs_wind / (16.0 * level * std::pow(0.4, n)), 1.0 / (n - 1.0));
}

std::vector<SpectralPeak> full_peaks(const TwoPeaks& two, double hs, double tp) {
  const double n = kK0 * std::sqrt(hs) + kK00;
  const double m2 = two.wind ? kM0 : kM0 * (1.0 - kB2 * std::exp(-hs / kB3));
  const double gamma = std::max(1.0, two.gamma1 * (1.0 + kKg0 * std::exp(-hs / kKg1)));
  std::vector<SpectralPeak> peaks = {make_peak(two.hs1, tp, unit_factor(n, kM0) * enhancement_factor(gamma, n, kM0))};
  peaks.front().gamma = gamma;
  if (two.hs2 > 0.0) {
    const double factor = unit_factor(n, m2);
    const double tp2 = two.wind ? two.tp2 : wind_sea_period(hs, two.hs2, n, factor);
    peaks.push_back(make_peak(two.hs2, tp2, factor));
    peaks.back().m = m2;
  }
  for (SpectralPeak& peak : peaks) peak.n = n;
  return peaks;
}

}  // namespace

double SpectralPeak::density(double omega) const {
  if (omega <= 0.0) return 0.0;
  const double x = omega / peak;
  const double base = scale * std::exp(-n * std::log(x) - n / m * std::pow(x, -m));
  if (gamma == 1.0) return base;
  const double off = (x - 1.0) / (x <= 1.0 ? 0.07 : 0.09);
  return base * std::pow(gamma, std::exp(-0.5 * off * off));
}

std::vector<SpectralPeak> ochi_hubble_peaks(const std::vector<SpectrumPart>& parts) {
  std::vector<SpectralPeak> peaks;
  for (const SpectrumPart& part : parts) {
    const double n = 4.0 * part.lambda + 1.0;
    peaks.push_back(make_peak(part.hs, part.tp, unit_factor(n, 4.0)));
    peaks.back().n = n;
  }
  return peaks;
}

std::vector<SpectralPeak> torsethaugen_peaks(double hs, double tp, TorsethaugenModel model) {
  const double tf = kAf * std::cbrt(hs);
  const TwoPeaks two = tp <= tf ? wind_dominated(hs, tp, tf) : swell_dominated(hs, tp, tf);
  return model == TorsethaugenModel::simplified ? simplified_peaks(two, tp) : full_peaks(two, hs, tp);
}

}  // namespace overbend
