/// Units and descriptions of the numbers that a stage of a lift has in summary.json, in their places. Lines and davits
/// stand under "*"; lists have one item.
#pragma once

#include "base/json.h"

namespace overbend {

/// As base/units.h writes them: "N*m", "N/m^2".
const Json& lift_stage_units();

/// As results.h5 has them: "N m", "Pa".
const Json& stored_lift_stage_units();

const Json& lift_stage_descriptions();

}  // namespace overbend
