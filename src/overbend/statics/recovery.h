/// From a state to results: pure functions of model and state.
#pragma once

#include "results/static_results.h"
#include "statics/statics.h"

namespace overbend {

/// Force and moment in the pipe by equilibrium of what lies on one side of a cut, W: more accurate than derivatives of
/// the shape, and exact at a roller, where the moment has a kink.
struct CutForces {
  Vec3 force = Vec3::Zero();   ///< On the part towards the anchor, by the part towards the tensioner [N].
  Vec3 moment = Vec3::Zero();  ///< [N m]
};

/// At every node.
std::vector<CutForces> cut_forces(LineSystem& system, const LineState& state);

/// Results of an equilibrium, without code checks: those are made from results, see checks/run_checks.h.
StaticResults recover_statics(const Model& model, const StaticSolution& solution);

}  // namespace overbend
