/// Water, seabed, current and waves as given in the model file.
#pragma once

#include <vector>

#include "model/description/seabed_description.h"
#include "model/description/waves_description.h"

namespace overbend {

struct CurrentPoint {
  double depth = 0.0;    ///< Depth below the mean water level [m].
  double speed = 0.0;    ///< [m/s]
  double towards = 0.0;  ///< Azimuth the current goes to [rad].
};

struct EnvironmentDescription {
  double water_depth = 0.0;               ///< At the stern shoe [m].
  double water_weight_density = 10.05e3;  ///< [N/m3]
  SeabedDescription seabed;
  std::vector<CurrentPoint> current;  ///< Rows by increasing depth.
  /// Groups of waves that exist at once. Calm water has one group of type none.
  std::vector<WavesDescription> waves = {WavesDescription{}};
};

}  // namespace overbend
