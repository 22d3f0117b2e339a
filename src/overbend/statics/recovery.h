/// From a state to results: pure functions of model and state.
#pragma once

#include "results/static_results.h"
#include "statics/statics.h"
#include "system/cut_forces.h"

namespace overbend {

/// At every node.
std::vector<CutForces> cut_forces(StaticSystem& system, const LineState& state);

StaticResults recover_statics(const Model& model, const StaticSolution& solution);

}  // namespace overbend
