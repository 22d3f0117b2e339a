/// Capytaine's netCDF files into HydrodynamicData; include seafiles/hydrodynamics_reader.h instead.
#pragma once

#include <optional>

#include "base/diagnostics.h"
#include "seafiles/hydrodynamics_reader.h"

namespace overbend {

/// Reads a dataset that Capytaine has exported with complex values separated: omega, radiating_dof, influenced_dof,
/// added_mass, radiation_damping, wave_direction [rad], Froude_Krylov_force and diffraction_force (or excitation_force)
/// of one body, hydrostatic_stiffness. Its time factor is exp(-i omega t), so forces are conjugated. Numbers are in SI
/// already; rho and g of the file must be those of the source within 0.1 %. There is no mean drift in such files.
///
/// Values about a `rotation_center` that the file states are moved to the centre of gravity, phases from the origin of
/// the file's axes too. `center_of_mass` has to be the model's, and `forward_speed` zero; another `water_depth` or mass
/// (`inertia_matrix`) than the model's is a warning.
std::optional<HydrodynamicData> read_capytaine(const HydrodynamicsSource& source, Diagnostics& diagnostics);

}  // namespace overbend
