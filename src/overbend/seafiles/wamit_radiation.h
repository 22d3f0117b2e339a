/// Readers of WAMIT radiation and hydrostatics files; include seafiles/hydrodynamics_reader.h instead.
#pragma once

#include <string>

#include "base/diagnostics.h"
#include "seafiles/hydrodynamics_reader.h"

namespace overbend::wamit {

/// Reads `.1`: added mass and damping. Returns false after an error.
bool read_radiation(const std::string& file, const HydrodynamicsSource& source, HydrodynamicData& data,
                    Diagnostics& diagnostics);
/// Reads `.hst`: hydrostatic stiffness. Returns false after an error.
bool read_hydrostatics(const std::string& file, const HydrodynamicsSource& source, HydrodynamicData& data,
                       Diagnostics& diagnostics);

}  // namespace overbend::wamit
