/// Checks of a stage of a lift.
#pragma once

#include "model/description/description.h"
#include "results/static_results.h"

namespace overbend {

/// Equivalent stress of pipe that other lines hold: von Mises of bending, effective tension and the hoop stress of
/// water and contents.
std::vector<CheckRow> lift_rows(const Description& description, const LiftResults& lift);

}  // namespace overbend
