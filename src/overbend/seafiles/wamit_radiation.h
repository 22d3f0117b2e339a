/// WAMIT's files of radiation and hydrostatics into HydrodynamicData; include seafiles/hydrodynamics_reader.h instead.
#pragma once

#include <string>

#include "base/diagnostics.h"
#include "seafiles/hydrodynamics_reader.h"

namespace overbend::wamit {

/// `.1`: added mass and damping. False after an error.
bool read_radiation(const std::string& file, const HydrodynamicsSource& source, HydrodynamicData& data,
                    Diagnostics& diagnostics);
/// `.hst`: hydrostatic stiffness. False after an error.
bool read_hydrostatics(const std::string& file, const HydrodynamicsSource& source, HydrodynamicData& data,
                       Diagnostics& diagnostics);

}  // namespace overbend::wamit
