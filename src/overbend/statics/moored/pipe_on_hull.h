/// What a pipe does to the hull that lays it, wherever the hull lies.
#pragma once

#include "statics/moored/pull_ahead.h"

namespace overbend {

/// Load of the pipe on the hull about midship, axes of the hull as drawn [N, N m]. With a stinger that floats on its
/// hinge: also what its weight and buoyancy are more than as drawn, which the hull's balance as drawn contains.
Vec6 pipe_load(const Model& model, const StaticSolution& pipe, const HullAtRest& hull);

/// The pipe follows the hull from place to place with the tension that the model wants, each equilibrium found from the
/// one before. `load`: where the hull lies first.
PipeOnHull pipe_on_hull(const Model& model, const StaticSolution& start, const HullAtRest& hull, const Vec6& load);

}  // namespace overbend
