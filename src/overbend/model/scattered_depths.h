/// Scattered depths onto a regular grid.
#pragma once

#include "model/seabed_description.h"

namespace overbend {

/// A regular grid over the extent of scattered depths, with about as many points as these, at most a million. At each
/// of its points the weighted least-squares plane through the nearest nine depths (weights 1/distance^2, so that it
/// passes through a depth on the point), no higher and no lower than these nine.
Bathymetry gridded(const Bathymetry& scattered);

}  // namespace overbend
