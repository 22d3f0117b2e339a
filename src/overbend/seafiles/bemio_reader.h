/// HDF5 files of BEMIO, the hydrodynamic data of WEC-Sim.
#pragma once

#include <optional>

#include "base/diagnostics.h"
#include "seafiles/hydrodynamics_reader.h"

namespace overbend {

/// True for the contents of such a file: groups simulation_parameters and body1.
bool is_bemio(const std::string& path);

/// Reads one body of a file as hull data about the model's centre of gravity. Added mass is over rho, radiation damping
/// over rho omega, excitation and stiffness over rho g, unless simulation_parameters/scaled is set; the first index of
/// an array is the force, then the motion (of all bodies), last the frequency. Phases lead the wave at the global X = Y
/// = 0. The arrays refer to the body's centre of gravity, properties/cg, in global axes.
std::optional<HydrodynamicData> read_bemio(const HydrodynamicsSource& source, Diagnostics& diagnostics);

}  // namespace overbend
