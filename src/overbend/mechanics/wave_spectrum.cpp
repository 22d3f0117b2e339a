#include "mechanics/wave_spectrum.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace overbend {
namespace {

// Frequency range of the components of a wind sea in peak frequencies: it contains all but 0.2 % of a Pierson-Moskowitz
// spectrum, and more of a peaked one. The step puts a node on the peak, where JONSWAP's width jumps.
constexpr double kLowest = 0.4, kHighest = 5.0, kStep = 0.001;

}  // namespace

WaveSpectrum::WaveSpectrum(const WavesDescription& waves) {
  switch (waves.type) {
    case WaveType::jonswap:
      gamma_ = waves.gamma.value_or(jonswap_gamma(waves.hs, waves.tp));
      set_wind_sea(waves);
      return;
    case WaveType::pierson_moskowitz:
      set_wind_sea(waves);
      return;
    case WaveType::ochi_hubble:
      set_peaks(ochi_hubble_peaks(waves.parts));
      return;
    case WaveType::torsethaugen:
      set_peaks(torsethaugen_peaks(waves.hs, waves.tp, waves.model));
      return;
    case WaveType::user:
      set_table(waves.spectrum);
      return;
    default:
      throw std::invalid_argument("these waves have no spectrum");
  }
}

void WaveSpectrum::set_wind_sea(const WavesDescription& waves) {
  if (!(waves.hs > 0.0) || !(waves.tp > 0.0)) throw std::invalid_argument("a wind sea needs hs and tp");
  peak_ = 2.0 * std::numbers::pi / waves.tp;
  variance_ = waves.hs * waves.hs / 16.0;
  const auto shape = [this](double x) { return jonswap_shape(x, gamma_); };
  const int cells = static_cast<int>(std::lround((kHighest - kLowest) / kStep));
  double sum = 0.0;
  omega_.push_back(kLowest * peak_);
  energy_.push_back(0.0);
  for (int i = 0; i < cells; ++i) {
    const double x = kLowest + kStep * i;
    // Evaluated just above the left end, so that the cell that begins at the peak has the width of that side.
    sum += kStep / 6.0 * (shape(x + 1e-12) + 4.0 * shape(x + 0.5 * kStep) + shape(x + kStep - 1e-12));
    omega_.push_back((x + kStep) * peak_);
    energy_.push_back(sum);
  }
  const double tail = -std::expm1(-1.25 / std::pow(kHighest, 4));
  for (double& energy : energy_) energy /= sum;
  share_inside_ = sum / (sum + tail);
  scale_ = variance_ / ((sum + tail) * peak_);
}

void WaveSpectrum::set_peaks(std::vector<SpectralPeak> peaks) {
  constexpr double kFarthest = 100.0;  // in peak frequencies: beyond it are less than 1e-6 of the energy
  constexpr double kRatio = 1.001;     // of neighbouring frequencies
  peaks_ = std::move(peaks);
  double lowest = std::numeric_limits<double>::infinity(), highest = 0.0;
  for (const SpectralPeak& peak : peaks_) {
    if (!(peak.hs > 0.0) || !(peak.peak > 0.0)) throw std::invalid_argument("a spectral peak needs hs and tp");
    lowest = std::min(lowest, peak.peak);
    highest = std::max(highest, peak.peak);
  }
  omega_.push_back(kLowest * lowest);
  energy_.push_back(0.0);
  double sum = 0.0;
  double a = omega_.front();
  while (a < kFarthest * highest) {
    const double b = a * kRatio;
    sum += (b - a) / 6.0 * (density(a) + 4.0 * density(0.5 * (a + b)) + density(b));
    if (b <= kHighest * highest) {
      omega_.push_back(b);
      energy_.push_back(sum);
    }
    a = b;
  }
  variance_ = sum;
  share_inside_ = energy_.back() / sum;
  const double inside = energy_.back();
  for (double& energy : energy_) energy /= inside;
}

void WaveSpectrum::set_table(const std::vector<SpectrumPoint>& points) {
  if (points.size() < 2) throw std::invalid_argument("a spectrum needs at least two points");
  table_ = points;
  const int parts = 1 + 4096 / static_cast<int>(points.size());
  omega_.push_back(points.front().omega);
  energy_.push_back(0.0);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double width = (points[i].omega - points[i - 1].omega) / parts;
    for (int part = 1; part <= parts; ++part) {
      const double omega = part == parts ? points[i].omega : points[i - 1].omega + width * part;
      // Density at the middle of the part: exact where it is linear.
      variance_ += (omega - omega_.back()) * density(0.5 * (omega + omega_.back()));
      omega_.push_back(omega);
      energy_.push_back(variance_);
    }
  }
  if (!(variance_ > 0.0)) throw std::invalid_argument("the spectrum has zero energy");
  for (double& energy : energy_) energy /= variance_;
}

double WaveSpectrum::density(double omega) const {
  if (!peaks_.empty()) {
    double sum = 0.0;
    for (const SpectralPeak& peak : peaks_) sum += peak.density(omega);
    return sum;
  }
  if (table_.empty()) return scale_ * jonswap_shape(omega / peak_, gamma_);
  if (omega < table_.front().omega || omega > table_.back().omega) return 0.0;
  const auto by_omega = [](double value, const SpectrumPoint& point) { return value < point.omega; };
  auto above = std::upper_bound(table_.begin(), table_.end(), omega, by_omega);
  if (above == table_.end()) --above;
  const SpectrumPoint &right = *above, &left = *(above - 1);
  const double share = (omega - left.omega) / (right.omega - left.omega);
  return left.density + share * (right.density - left.density);
}

double WaveSpectrum::quantile(double share) const {
  const auto above = std::upper_bound(energy_.begin() + 1, energy_.end() - 1, share);
  const auto i = static_cast<std::size_t>(above - energy_.begin());
  const double cell = energy_[i] - energy_[i - 1];
  const double part = cell > 0.0 ? std::clamp((share - energy_[i - 1]) / cell, 0.0, 1.0) : 0.0;
  return omega_[i - 1] + part * (omega_[i] - omega_[i - 1]);
}

}  // namespace overbend
