/// Retardation functions of a hull: damping over all frequencies, its kernel in time, and the matching A_inf.
#pragma once

#include <vector>

#include "hull/radiation.h"
#include "model/description/hydrodynamic_data.h"

namespace overbend {

/// B(omega) as a function that is linear between nodes from 0 to far beyond the data, so that every integral over it is
/// exact in time and frequency.
struct DampingSpectrum {
  std::vector<double> omega;  ///< From 0, ascending; includes the frequencies of the data [rad/s].
  std::vector<Mat6> damping;  ///< Symmetric, at each of them [N s/m, N s, N m s].
  double last = 0.0;          ///< Maximum frequency of the data; above it B ~ omega^-n [rad/s].
  double typical = 0.0;       ///< Central frequency of the damping data: the scale of all times [rad/s].
  Mat6 tail_exponent = Mat6::Zero();
  double max_negative_damping =
      0.0;  ///< Maximum negative damping of the data that was set to zero, share of the peaks.
  /// A_inf that matches this damping: mean of A - (A - A_inf of the damping) over the middle of the data.
  Mat6 added_mass = Mat6::Zero();
};

/// Returns the data interpolated by cubic splines from zero, extended below the first frequency by a power law
/// (exponent 1 at least) through the first three points and above the last by omega^-n. n of each pair makes A_inf by
/// Ogilvie's relation [ogilvie1964] that of the file, between 2 and 6; 3 if it changes A_inf by less than 0.5 % or the
/// file has none. Matrices are made symmetric and without negative eigenvalues. `data` has at least four frequencies.
DampingSpectrum damping_spectrum(const HydrodynamicData& data);

/// Returns A(omega) - A_inf by Ogilvie's relation, (2/pi) PV integral of B(x)/(x^2 - omega^2) dx [kg, kg m, kg m2].
Mat6 added_mass_above_infinite(const DampingSpectrum& spectrum, double omega);

/// Returns K(t) = (2/pi) integral of B cos(omega t) [N/m, N, N m].
Mat6 retardation(const DampingSpectrum& spectrum, double time);

/// Returns K at i * interval, i = 0 to count - 1.
std::vector<Mat6> retardation_samples(const DampingSpectrum& spectrum, double interval, int count);

/// Returns its integrals on a grid, for direct convolution, up to the time beyond which |K| stays below 1e-3 of its
/// peak, at least 22 and at most 87 over the typical frequency. The mean of K over that time is subtracted, because
/// B(0) would otherwise not be zero.
RadiationSamples convolution_samples(const DampingSpectrum& spectrum);

}  // namespace overbend
