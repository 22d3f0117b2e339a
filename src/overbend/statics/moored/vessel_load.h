/// What the pipe does to the vessel that carries it.
#pragma once

#include "model/description/hydrodynamic_data.h"
#include "statics/equations/static_system.h"

namespace overbend {

/// Force and moment of a pipe at rest on its vessel, by rollers, tensioner and wires, about the vessel's origin V; axes
/// W [N, N m]. The guide's moment included.
Vec6 load_on_vessel(StaticSystem& system, const LineState& state);

}  // namespace overbend
