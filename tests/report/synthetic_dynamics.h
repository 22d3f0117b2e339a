/// Dynamic results made up around a static state, plausible to look at: for tests and pictures of the report, where a
/// run of hours would only cost time. Nothing random: the same every time.
#pragma once

#include "results/dynamic_results.h"

namespace overbend::testing {

/// An hour of a sea with a peak period of 12.9 s. `calm`: no support loses contact, no impacts, too few peaks.
DynamicResults synthetic_dynamics(const StaticResults& statics, bool calm = false);

}  // namespace overbend::testing
