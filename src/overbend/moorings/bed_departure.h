/// How far the bed is from the straight one that the catenary of a mooring line stands on (CatenarySite).
#pragma once

#include <vector>

#include "model/site/bed_surface.h"

namespace overbend {

struct BedDeparture {
  double inside = 0.0;       ///< How deep the line runs in the bed, at most [m].
  double over_hollow = 0.0;  ///< How far the bed falls away under what is taken to lie on it, at most [m].
  double inside_at = 0.0, hollow_at = 0.0;  ///< Where: horizontal distance from the anchor [m].
};

/// `shape_W`: of the line at rest, from fairlead to anchor. Zero over a plane.
BedDeparture bed_departure(const BedSurface& bed, const std::vector<Vec3>& shape_W);

}  // namespace overbend
