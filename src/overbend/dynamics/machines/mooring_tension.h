/// Tensions of mooring lines in time, whatever they are made of.
#pragma once

#include "system/assembly.h"

namespace overbend {

/// Whether mooring lines are quasi-static: springs of the first free body, and no lines of the system.
bool moored_quasi_statically(const Assembly& assembly);

/// Of the mooring line of that number: at its fairlead (LineEnd::last) or its anchor, in the state evaluated last [N].
/// Lines of elements stand among the lines of the system one after the other; quasi-static ones are springs of the
/// first free body.
double mooring_tension(const Assembly& assembly, const SystemState& state, std::size_t mooring, LineEnd end);

}  // namespace overbend
