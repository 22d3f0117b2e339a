/// Load of a pipe on its lay vessel as a function of the vessel's pose.
#pragma once

#include "statics/moored/pull_ahead.h"

namespace overbend {

/// Load of the pipe on the hull about midship, nominal axes of the hull [N, N m]. With a floating hinged stinger:
/// includes the change of its weight and buoyancy loads from the nominal ones, which are part of the hull's nominal
/// equilibrium.
Vec6 pipe_load(const Model& model, const StaticSolution& pipe, const StaticHull& hull);

/// Returns a function that solves the pipe at successive hull positions with the model's target tension, each with a
/// warm start from the last. `load`: at the hull's initial position.
PipeOnHull pipe_on_hull(const Model& model, const StaticSolution& start, const StaticHull& hull, const Vec6& load);

}  // namespace overbend
