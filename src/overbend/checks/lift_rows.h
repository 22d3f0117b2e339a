/// Checks of a stage of a lift.
#pragma once

#include "model/description/description.h"
#include "results/static_results.h"

namespace overbend {

/// Equivalent stress of lifted pipe, and tensions of lines over their breaking loads. `statics` with a lift and its
/// lines.
CheckTable check_lift(const Description& description, const StaticResults& statics);

}  // namespace overbend
