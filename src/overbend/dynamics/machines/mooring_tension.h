/// Tensions of mooring lines in dynamics, of elements or quasi-static.
#pragma once

#include "system/assembly.h"

namespace overbend {

/// True if the mooring lines are quasi-static: springs of the first free body instead of lines of the system.
bool moored_quasi_statically(const Assembly& assembly);

/// Returns the tension of the mooring line of that number at its fairlead (LineEnd::last) or anchor in the last
/// evaluated state [N]. Lines of elements are consecutive lines of the system; quasi-static lines are springs of the
/// first free body.
double mooring_tension(const Assembly& assembly, const SystemState& state, std::size_t mooring, LineEnd end);

}  // namespace overbend
