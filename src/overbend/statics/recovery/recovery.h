/// From a state to results: pure functions of model and state.
#pragma once

#include "results/static_results.h"
#include "statics/recovery/recovery_stress.h"
#include "statics/solver/statics.h"
#include "system/cut_forces.h"

namespace overbend {

/// At every node.
std::vector<CutForces> cut_forces(StaticSystem& system, const LineState& state);

/// Cut at xi inside an element, by balance of what lies between it and the element's first node.
CutForces cut_at(const StaticSystem& system, const LineState& state, const std::vector<CutForces>& cuts, int element,
                 double xi);

StationCut make_station(const StaticSystem& system, const LineState& state, const CutForces& cut, int element,
                        double xi);

/// What follows from the equilibrium alone: without what is warned of, and without what the current adds.
StaticResults recover_state(const Model& model, const StaticSolution& solution);

/// Results of an equilibrium, without code checks: those are made from results, see checks/run_checks.h.
StaticResults recover_statics(const Model& model, const StaticSolution& solution);

}  // namespace overbend
