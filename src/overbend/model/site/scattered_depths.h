/// Interpolation of scattered depths on a regular grid.
#pragma once

#include "model/description/seabed_description.h"

namespace overbend {

/// Returns a grid over the extent of scattered depths. Depths on survey lines, with some crossings missing or measured
/// repeatedly, keep these lines; others use a regular grid of half the typical distance between neighbours, at most a
/// million points. At each grid point without a depth of its own: the weighted least-squares plane through the nearest
/// nine depths (weights 1/distance^2, so that it interpolates a depth at the point), limited to the range of these
/// nine; far from all depths the mean of the neighbouring grid points.
Bathymetry grid_scattered_depths(const Bathymetry& scattered);

}  // namespace overbend
