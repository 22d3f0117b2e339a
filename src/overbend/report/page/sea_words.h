/// The sea and the vessel's motion in it, in words.
#pragma once

#include <string>

#include "model/description/description.h"

namespace overbend {

/// "JONSWAP, Hs 4 m, Tp 12.9 s, gamma 1.35 by rule, from 180 deg, long-crested"; "calm water". Gamma is given where it
/// is the rule's and not the user's, too.
std::string sea_words(const WavesDescription& waves);

/// "RAOs of rao.csv", "harmonic: heave, pitch", "none, fixed".
std::string motion_words(const VesselDescription& vessel);

}  // namespace overbend
