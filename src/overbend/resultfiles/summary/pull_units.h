/// Units of the numbers of a stage of a pull along the seabed in summary.json.
#pragma once

#include "base/json.h"

namespace overbend {

/// Returns the units as in base/units.h. `lay`: units of a static analysis, which a stage has as well; those of the
/// pull replace them for the same names.
Json pull_stage_units(const Json& lay);

}  // namespace overbend
