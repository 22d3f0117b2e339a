/// Wave spectra that are sums of peaks: Ochi-Hubble and Torsethaugen.
#pragma once

#include <vector>

#include "model/description/waves_description.h"

namespace overbend {

/// Peak of the density S(omega) = scale x^-n exp(-n/m x^-m) gamma^exp(-(x - 1)^2/(2 sigma^2)), x = omega/peak, with the
/// sigma of JONSWAP: 0.07 up to the peak and 0.09 beyond.
struct SpectralPeak {
  double scale = 0.0;  ///< [m2 s]
  double peak = 0.0;   ///< [rad/s]
  double n = 5.0, m = 4.0;
  double gamma = 1.0;
  double hs = 0.0;  ///< Nominal significant wave height [m].

  /// Returns the density [m2 s]; 0 at and below frequency 0.
  double density(double omega) const;
};

/// Returns the peaks of a six-parameter spectrum [ochi1976]: n = 4 lambda + 1, m = 4, each part with exactly Hs^2/16.
std::vector<SpectralPeak> ochi_hubble_peaks(const std::vector<SpectrumPart>& parts);

/// Returns the primary and the secondary peak of Torsethaugen's spectrum for a significant wave height [m] and a peak
/// period [s], simplified [torsethaugen2004] or full [torsethaugen1996].
///
/// The peaks are normalised by the fitted factors of the publications, so that Hs of the density differs from the given
/// one by up to about 1 %; nothing is rescaled. A peak enhancement below 1, which the formulas give outside of the
/// range of the data, is 1.
std::vector<SpectralPeak> torsethaugen_peaks(double hs, double tp, TorsethaugenModel model);

}  // namespace overbend
