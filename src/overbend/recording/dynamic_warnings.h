/// What in a time-domain run calls for a second look, in words: results.warnings.
#pragma once

#include "results/dynamic_results.h"

namespace overbend {

/// Compression anywhere at any time. Appended to `results.warnings`.
void warn_of_slack(const StaticResults& statics, DynamicResults& results);

}  // namespace overbend
