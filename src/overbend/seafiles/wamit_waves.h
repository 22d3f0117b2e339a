/// Readers of WAMIT wave force files; include seafiles/hydrodynamics_reader.h instead.
#pragma once

#include <string>

#include "base/diagnostics.h"
#include "seafiles/hydrodynamics_reader.h"

namespace overbend::wamit {

/// Reads `.2` or `.3`: excitation. Returns false after an error.
bool read_excitation(const std::string& file, const HydrodynamicsSource& source, HydrodynamicData& data,
                     Diagnostics& diagnostics);
/// Reads `.7`, `.8` or `.9`: mean drift. Returns false after an error.
bool read_drift(const std::string& file, const HydrodynamicsSource& source, HydrodynamicData& data,
                Diagnostics& diagnostics);

}  // namespace overbend::wamit
