/// A stage of a lift for summary.json.
#pragma once

#include "base/json.h"
#include "results/lift_results.h"

namespace overbend {

/// Returns lines, davits, gap or weld, by their names. SI.
Json lift_json(const LiftResults& lift);

}  // namespace overbend
