/// Distance between the seabed and the straight bed assumed by the catenary of a mooring line (CatenarySite).
#pragma once

#include <vector>

#include "model/site/seabed_surface.h"

namespace overbend {

struct BedDeparture {
  double inside = 0.0;       ///< Maximum depth of the line below the seabed [m].
  double over_hollow = 0.0;  ///< Maximum depth of the seabed below a part that is assumed to lie on it [m].
  double inside_at = 0.0, hollow_at = 0.0;  ///< Horizontal distances of both from the anchor [m].
};

/// `shape_W`: static shape of the line from fairlead to anchor. Zero over a plane.
BedDeparture bed_departure(const SeabedSurface& bed, const std::vector<Vec3>& shape_W);

}  // namespace overbend
