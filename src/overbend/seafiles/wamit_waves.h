/// WAMIT's files of wave forces into HydrodynamicData; include seafiles/hydrodynamics_reader.h instead.
#pragma once

#include <string>

#include "base/diagnostics.h"
#include "seafiles/hydrodynamics_reader.h"

namespace overbend::wamit {

/// `.2`, `.3`: excitation. False after an error.
bool read_excitation(const std::string& file, const HydrodynamicsSource& source, HydrodynamicData& data,
                     Diagnostics& diagnostics);
/// `.7`, `.8`, `.9`: mean drift. False after an error.
bool read_drift(const std::string& file, const HydrodynamicsSource& source, HydrodynamicData& data,
                Diagnostics& diagnostics);

}  // namespace overbend::wamit
