/// Units and descriptions of the numbers of a lift stage, with the structure of summary.json. Lines and davits are
/// under "*"; lists have one item.
#pragma once

#include "base/json.h"

namespace overbend {

/// Returns the units as in base/units.h: "N*m", "N/m^2".
const Json& lift_stage_units();

/// Returns the units as in results.h5: "N m", "Pa".
const Json& stored_lift_stage_units();

/// Returns the descriptions of the numbers.
const Json& lift_stage_descriptions();

}  // namespace overbend
