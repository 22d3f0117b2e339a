/// Volume that a hull displaces, from the forces of long waves on it.
#pragma once

#include <optional>

#include "model/description/hydrodynamic_data.h"

namespace overbend {

struct HullSize {
  double length = 0.0, draught = 0.0, depth = 0.0;  ///< Of the hull, of the water [m].
};

struct VolumeEstimate {
  double volume = 0.0;       ///< [m3]
  double uncertainty = 0.0;  ///< By how much the longest wave alone differs, relative.
};

/// In waves far longer than the hull the surge force is that of the accelerated water on the displaced and the added
/// mass: |X| = rho (V + A / rho) times the mean acceleration over length and draught. Of the two longest waves along
/// the hull, extrapolated to infinite length, where what is left out vanishes with the square of the wave number;
/// nothing where the file has none that is long enough.
std::optional<VolumeEstimate> displaced_volume(const HydrodynamicData& data, const HullSize& hull);

}  // namespace overbend
