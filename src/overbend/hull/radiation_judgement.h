/// How well the radiation of a hull in time represents its hydrodynamic file where it matters.
#pragma once

#include <string>
#include <vector>

#include "base/finding.h"
#include "hull/radiation.h"
#include "mechanics/sea.h"
#include "model/description/hydrodynamic_data.h"

namespace overbend {

/// Misfit of one mode, as shares of the largest value that the file has in the band of the waves.
struct RadiationMisfit {
  int mode = 0;
  double added_mass = 0.0, damping = 0.0;  ///< Root mean square over the waves' energy, or at the lowest frequency [-].
};

/// Of the six modes by themselves. In calm water all frequencies of the file count alike.
std::vector<RadiationMisfit> radiation_misfits(const RadiationModel& model, const HydrodynamicData& data,
                                               const Sea& sea);

/// A sentence for each mode whose misfit is beyond 5 %.
Findings misfit_findings(const std::vector<RadiationMisfit>& misfits);

}  // namespace overbend
