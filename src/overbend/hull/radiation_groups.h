/// Groups of coupled modes of a hull and the exponentials that represent each; include hull/make_radiation.h instead.
#pragma once

#include <vector>

#include "hull/radiation_fit.h"
#include "hull/retardation.h"

namespace overbend {

/// What is fitted for a hull.
struct RadiationSource {
  const HydrodynamicData& data;
  DampingSpectrum spectrum;
  std::vector<Mat6> kernel;  ///< Samples of K, `interval` apart.
  double interval = 0.0;     ///< [s]
};

/// Damping over all frequencies, and its kernel on a grid and over a time that scale with its typical frequency (every
/// 0.2 s over 80 s for a barge of 120 m), finer where the data reach high frequencies.
RadiationSource radiation_source(const HydrodynamicData& data);

/// Modes that are coupled by damping, directly or through others; those that do not radiate are left out.
std::vector<std::vector<int>> coupled_groups(const HydrodynamicData& data);

/// Largest diagonal values of added mass or damping over the frequencies of the data.
Vec6 largest_diagonal(const HydrodynamicData& data, Mat6 RadiationPoint::*what);

struct ChosenFit {
  GroupFit fit;          ///< Scaled: times unit(i) unit(j).
  Eigen::VectorXd unit;  ///< sqrt(K_ii(0)) of each mode.
  int order = 0;         ///< Poles, a conjugate pair counted as two; 0: none is good enough.
};

/// The lowest even order from 6 to 20 whose fit is good (0.5 % in damping and added mass), else the best of those that
/// are fair (1 %).
ChosenFit choose_fit(const RadiationSource& source, const std::vector<int>& modes);

}  // namespace overbend
