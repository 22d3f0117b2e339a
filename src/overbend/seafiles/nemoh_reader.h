/// Results of Nemoh: Nemoh.cal with the folders Results and Mesh.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "seafiles/hydrodynamics_reader.h"

namespace overbend {

/// Reads the results of a run as hull data about the model's centre of gravity. `source.path` is Nemoh.cal or its
/// folder. Read are Results/RadiationCoefficients.tec (a zone is a motion, its columns are added mass and damping of
/// the forces), Results/ExcitationForce.tec (modulus and angle; angles are lags in radians, because the time factor is
/// exp(-i omega t)), Mesh/KH.dat (stiffness with weight, about the centre of gravity of Mesh/Hydrostatics.dat). Motions
/// are about the points in Nemoh.cal, phases refer to the point XEFF, YEFF there.
std::optional<HydrodynamicData> read_nemoh(const HydrodynamicsSource& source, Diagnostics& diagnostics);

/// Returns the files of a run, as far as they exist.
std::vector<std::string> nemoh_files(const std::string& path);

}  // namespace overbend
