/// A lay that was pushed sideways as a start for one that is not.
#pragma once

#include "statics/solver/statics.h"

namespace overbend {

/// The line of `solution` turned piece by piece about the vertical into the plane of the model's route: from the
/// tensioner down every chord keeps its length and its height, so that nothing is stretched or bent up or down, and
/// only what pushed the line aside is gone. Where the route bends the solution as it is.
StaticSolution laid_flat(const Model& model, const StaticSolution& solution);

}  // namespace overbend
