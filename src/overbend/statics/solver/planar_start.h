/// Warm start in the lay plane from a lay that was pushed sideways.
#pragma once

#include "statics/solver/statics.h"

namespace overbend {

/// Rotates the line of `solution` piece by piece about the vertical into the plane of the model's route: from the
/// tensioner down each chord keeps its length and height, so that the line is not stretched or bent in the vertical
/// plane, and only the lateral displacement is removed. On a curved route returns the solution unchanged.
StaticSolution flattened_lay(const Model& model, const StaticSolution& solution);

}  // namespace overbend
