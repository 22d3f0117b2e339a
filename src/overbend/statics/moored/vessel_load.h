/// Load of the pipe on the vessel that carries it.
#pragma once

#include "model/description/hydrodynamic_data.h"
#include "statics/equations/static_system.h"

namespace overbend {

/// Force and moment of a pipe in equilibrium on its vessel, by rollers, tensioner and wires, about the vessel's origin
/// V; axes W [N, N m]. Includes the moment on the guide.
Vec6 load_on_vessel(StaticSystem& system, const LineState& state);

}  // namespace overbend
