/// Initial seabed friction under a line in static equilibrium.
#pragma once

#include "system/line.h"
#include "system/state.h"

namespace overbend {

/// Sets the elastic stretch of the seabed friction at every point of a line to its static value, so that a run begins
/// in equilibrium.
void set_initial_seabed_friction(const Line& line, LineState& state);

}  // namespace overbend
