/// One-dimensional wave spectra: density, and distribution of energy over frequency.
#pragma once

#include <vector>

#include "mechanics/spectral_peaks.h"
#include "model/description/waves_description.h"
#include "model/waves/wave_theory.h"

namespace overbend {

/// One-sided spectral density of the surface elevation, S(omega) [m2 s], and its integral.
///
/// JONSWAP and Pierson-Moskowitz are scaled so that the density integrates over all frequencies to Hs^2/16 exactly, for
/// any gamma. Ochi-Hubble and Torsethaugen have the density of their publications. A user's spectrum is linear between
/// its points and zero outside.
class WaveSpectrum {
 public:
  /// Throws std::invalid_argument for a wave without spectrum, or a user's spectrum of fewer than two points or zero
  /// energy.
  explicit WaveSpectrum(const WavesDescription& waves);

  /// Returns S(omega) [m2 s].
  double density(double omega) const;
  /// Variance of the elevation over all frequencies [m2].
  double variance() const { return variance_; }
  /// Fraction of the variance between the lowest and highest frequency used for components.
  double share_inside() const { return share_inside_; }
  /// Returns the frequency [rad/s] below which the fraction `share`, 0 to 1, of the energy inside lies.
  double quantile(double share) const;

 private:
  void set_wind_sea(const WavesDescription& waves);
  void set_peaks(std::vector<SpectralPeak> peaks);
  void set_table(const std::vector<SpectrumPoint>& points);

  double peak_ = 0.0, gamma_ = 1.0, scale_ = 0.0;  // wind sea only
  std::vector<SpectralPeak> peaks_;                // Ochi-Hubble, Torsethaugen
  std::vector<SpectrumPoint> table_;               // user only
  double variance_ = 0.0, share_inside_ = 1.0;
  std::vector<double> omega_, energy_;  // cumulative, energy_ from 0 to 1
};

}  // namespace overbend
