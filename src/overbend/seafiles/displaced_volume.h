/// Displaced volume of a hull, estimated from its excitation in long waves.
#pragma once

#include <optional>

#include "model/description/hydrodynamic_data.h"

namespace overbend {

struct HullSize {
  double length = 0.0, draught = 0.0, depth = 0.0;  ///< Length and draught of the hull, water depth [m].
};

struct VolumeEstimate {
  double volume = 0.0;       ///< [m3]
  double uncertainty = 0.0;  ///< Relative difference to the estimate from the longest wave alone.
};

/// Estimates the displaced volume [m3]. In waves much longer than the hull, the surge force is |X| = rho (V + A / rho)
/// times the water acceleration averaged over length and draught, with the surge added mass A. The estimates from the
/// two longest waves along the hull are extrapolated to infinite length (error proportional to the square of the wave
/// number). Returns nothing if the file has no wave that is long enough.
std::optional<VolumeEstimate> displaced_volume(const HydrodynamicData& data, const HullSize& hull);

}  // namespace overbend
