/// Scattered depths onto a regular grid.
#pragma once

#include "model/description/seabed_description.h"

namespace overbend {

/// A grid over the extent of scattered depths. Depths on the lines of a survey of which some crossings have none or
/// several stay where they are; others are put on a regular grid of half the usual distance between neighbours, at most
/// a million points. At each point of the grid that has no depth of its own the weighted least-squares plane through
/// the nearest nine depths (weights 1/distance^2, so that it passes through a depth on the point), no higher and no
/// lower than these nine; far from all depths the mean of the grid's points beside it.
Bathymetry gridded(const Bathymetry& scattered);

}  // namespace overbend
