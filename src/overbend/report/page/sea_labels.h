/// Descriptions of the sea and the vessel's motion.
#pragma once

#include <string>

#include "model/description/description.h"
#include "model/site/wave_groups.h"

namespace overbend {

/// Returns "JONSWAP, Hs 4 m, Tp 12.9 s, gamma 1.35 by rule, from 180 deg, long-crested"; "calm water". Gamma is
/// included even if it follows from the rule and not from the user. Several groups of waves are separated by "; ", with
/// the height of all together in front.
std::string sea_label(const WaveGroups& groups);

/// Returns "RAOs of rao.csv", "harmonic: heave, pitch", "none, fixed".
std::string motion_label(const VesselDescription& vessel);

}  // namespace overbend
