/// Accuracy of the time-domain radiation of a hull against its hydrodynamic file at the wave frequencies.
#pragma once

#include <string>
#include <vector>

#include "base/finding.h"
#include "hull/radiation.h"
#include "mechanics/sea.h"
#include "model/description/hydrodynamic_data.h"

namespace overbend {

/// Misfit of one mode, relative to the file's maximum value in the band of the waves.
struct RadiationMisfit {
  int mode = 0;
  double added_mass = 0.0, damping = 0.0;  ///< Root mean square over the waves' energy, or at the lowest frequency [-].
};

/// Returns the misfits of the six single modes. In calm water all frequencies of the file count alike.
std::vector<RadiationMisfit> radiation_misfits(const RadiationModel& model, const HydrodynamicData& data,
                                               const Sea& sea);

/// Returns a warning for each mode with a misfit beyond 5 %.
Findings misfit_findings(const std::vector<RadiationMisfit>& misfits);

}  // namespace overbend
