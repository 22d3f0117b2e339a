/// Checks of a stage of a lift.
#pragma once

#include "model/description/description.h"
#include "results/static_results.h"

namespace overbend {

/// Equivalent stress of pipe that other lines hold.
std::vector<CheckRow> lift_rows(const CheckSettings& settings, const LiftResults& lift);

}  // namespace overbend
