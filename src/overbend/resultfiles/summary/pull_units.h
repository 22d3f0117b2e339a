/// Units of the numbers that a stage of a pull along the bed has in summary.json.
#pragma once

#include "base/json.h"

namespace overbend {

/// As base/units.h writes them. `lay`: those of a static analysis, which a stage has as well, of the pull's own names
/// those of the pull.
Json pull_stage_units(const Json& lay);

}  // namespace overbend
