/// Reads netCDF files of Capytaine into HydrodynamicData; include seafiles/hydrodynamics_reader.h instead.
#pragma once

#include <optional>

#include "base/diagnostics.h"
#include "seafiles/hydrodynamics_reader.h"

namespace overbend {

/// Reads a dataset exported by Capytaine with complex values separated: omega, radiating_dof, influenced_dof,
/// added_mass, radiation_damping, wave_direction [rad], Froude_Krylov_force and diffraction_force (or excitation_force)
/// of one body, hydrostatic_stiffness. Its time factor is exp(-i omega t), so forces are conjugated. Numbers are in SI
/// units; rho and g of the file must agree with `source` within 0.1 %. These files contain no mean drift.
///
/// Values about the file's `rotation_center` are moved to the centre of gravity, and phases are moved from the origin
/// of the file's axes. `center_of_mass` must equal the model's, and `forward_speed` must be zero. A `water_depth` or
/// mass
/// (`inertia_matrix`) that differs from the model's is a warning.
std::optional<HydrodynamicData> read_capytaine(const HydrodynamicsSource& source, Diagnostics& diagnostics);

}  // namespace overbend
