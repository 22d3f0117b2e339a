/// Heights and periods of wave groups that follow from other keys.
#pragma once

#include "model/description/description.h"

namespace overbend {

/// Fills the peak period from `tz`, and height and peak period of an Ochi-Hubble spectrum from its parts: the root of
/// the sum of their squared heights, and the period of the higher part.
void resolve_waves(Description& description);

}  // namespace overbend
