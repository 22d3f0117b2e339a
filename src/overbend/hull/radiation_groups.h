/// Groups of coupled modes of a hull and their exponentials; include hull/make_radiation.h instead.
#pragma once

#include <vector>

#include "hull/radiation_fit.h"
#include "hull/retardation.h"

namespace overbend {

/// Input of the fit for a hull.
struct RadiationSource {
  const HydrodynamicData& data;
  DampingSpectrum spectrum;
  std::vector<Mat6> kernel;  ///< Samples of K, `interval` apart.
  double interval = 0.0;     ///< [s]
};

/// Returns the damping over all frequencies and its kernel, with a grid and duration that scale with the typical
/// frequency (every 0.2 s over 80 s for a barge of 120 m), finer if the data reach high frequencies.
RadiationSource radiation_source(const HydrodynamicData& data);

/// Returns the groups of modes coupled by damping, directly or through others, without modes that do not radiate.
std::vector<std::vector<int>> coupled_groups(const HydrodynamicData& data);

/// Returns the maximum diagonal values of added mass or damping over the frequencies of the data.
Vec6 max_diagonals(const HydrodynamicData& data, Mat6 RadiationPoint::*what);

/// Fit of one group of modes.
struct ChosenFit {
  GroupFit fit;          ///< Scaled: times unit(i) unit(j).
  Eigen::VectorXd unit;  ///< sqrt(K_ii(0)) of each mode.
  int order = 0;         ///< Number of poles, a conjugate pair counted as two; 0: no order is accurate enough.
};

/// Returns the fit of the lowest even order from 6 to 20 with a good accuracy (0.5 % in damping and added mass), else
/// the best one with a fair accuracy (1 %).
ChosenFit choose_fit(const RadiationSource& source, const std::vector<int>& modes);

}  // namespace overbend
