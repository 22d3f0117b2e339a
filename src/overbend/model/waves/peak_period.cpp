#include "model/waves/peak_period.h"

#include <cmath>
#include <numbers>

#include "model/waves/wave_theory.h"

namespace overbend {
namespace {

/// Zeroth and second moments of the density over the frequency ratio x = omega / omega_p.
struct Moments {
  double m0 = 0.0, m2 = 0.0;
};

/// Adds what the peak enhancement adds between two ratios, by Simpson's rule.
void add_peak(double from, double to, double gamma, Moments& moments) {
  constexpr int kIntervals = 400;
  const double step = (to - from) / kIntervals;
  for (int i = 0; i <= kIntervals; ++i) {
    const double x = from + i * step;
    const double added = jonswap_shape(x, gamma) - jonswap_shape(x, 1.0);
    const double weight = step / 3.0 * (i == 0 || i == kIntervals ? 1.0 : i % 2 == 1 ? 4.0 : 2.0);
    moments.m0 += weight * added;
    moments.m2 += weight * x * x * added;
  }
}

}  // namespace

double tp_over_tz(double gamma) {
  // Pierson-Moskowitz in closed form; the enhancement vanishes eight widths from the peak.
  constexpr double kBelow = 0.07, kAbove = 0.09, kReach = 8.0;
  Moments moments{1.0, std::sqrt(1.25 * std::numbers::pi)};
  if (gamma != 1.0) {
    add_peak(1.0 - kReach * kBelow, 1.0, gamma, moments);
    add_peak(1.0, 1.0 + kReach * kAbove, gamma, moments);
  }
  return std::sqrt(moments.m2 / moments.m0);
}

double peak_period(double hs, double tz, std::optional<double> gamma) {
  if (gamma) return tz * tp_over_tz(*gamma);
  // The peak is sharper for a shorter period, so that the period of a given Tz is between those of gamma 1 and 5.
  double low = tz * tp_over_tz(5.0), high = tz * tp_over_tz(1.0);
  constexpr int kHalvings = 50;
  for (int i = 0; i < kHalvings; ++i) {
    const double tp = 0.5 * (low + high);
    (tp > tz * tp_over_tz(jonswap_gamma(hs, tp)) ? high : low) = tp;
  }
  return 0.5 * (low + high);
}

}  // namespace overbend
