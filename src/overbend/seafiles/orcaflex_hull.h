/// Hull data of a vessel type in an OrcaFlex text data file.
#pragma once

#include <optional>

#include "base/diagnostics.h"
#include "seafiles/hydrodynamics_reader.h"

namespace overbend {

/// Reads load RAOs, added mass, damping, hydrostatic stiffness and, if present, the wave drift of a draught of a vessel
/// type as hull data about the model's centre of gravity. Load RAOs refer to RAOOrigin and PhaseOrigin, matrices to
/// ReferenceOrigin, whose height over the water is that of ReferenceOriginDatumPosition. Conventions, units and
/// symmetry are those stated in the file. Displacement RAOs are not needed.
std::optional<HydrodynamicData> read_orcaflex_hull(const HydrodynamicsSource& source, Diagnostics& diagnostics);

}  // namespace overbend
