/// Tensions of the mooring lines of a lay in time, whatever the lines are made of.
#pragma once

#include "system/assembly.h"

namespace overbend {

/// Whether mooring lines are quasi-static: springs of the first free body, and no lines of the system.
bool moored_quasi_statically(const Assembly& assembly);

/// Of the mooring line of that number: at its fairlead (LineEnd::last) or its anchor, in the state evaluated last [N].
/// Lines of elements follow the pipe among the lines of the system; quasi-static ones are springs of the first free
/// body.
double mooring_tension(const Assembly& assembly, const SystemState& state, std::size_t mooring, LineEnd end);

}  // namespace overbend
