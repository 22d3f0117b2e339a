/// Power spectral density of a record by averaging over segments, [welch1967].
#pragma once

#include <span>
#include <vector>

namespace overbend {

/// One-sided: its integral over frequency is the variance.
struct PowerSpectrum {
  std::vector<double> frequency;  ///< Equally spaced from 0 [Hz].
  std::vector<double> density;    ///< [units^2/Hz]
  int segments = 0;               ///< Number of averaged segments.
};

/// Returns the spectrum of equally spaced values, `step` [s] apart, about their mean. Hann window, segments that
/// overlap by half. The length of a segment follows from the record: the power of two between 512 and 2048 that leaves
/// at least seven segments, so that there are 257 to 1025 frequencies; a record shorter than 512 is one segment,
/// zero-padded. Up to half a segment at the end is unused. Empty for fewer than 8 values.
PowerSpectrum power_spectrum(std::span<const double> values, double step);

}  // namespace overbend
