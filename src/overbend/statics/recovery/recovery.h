/// Recovery of results from a state: pure functions of model and state.
#pragma once

#include "results/static_results.h"
#include "statics/recovery/recovery_stress.h"
#include "statics/solver/statics.h"
#include "system/cut_forces.h"

namespace overbend {

/// Section forces at every node.
std::vector<CutForces> cut_forces(StaticSystem& system, const LineState& state);

/// Section forces at xi inside an element, from the equilibrium of the part between xi and the element's first node.
CutForces cut_at(const StaticSystem& system, const LineState& state, const std::vector<CutForces>& cuts, int element,
                 double xi);

/// Returns the station at xi of an element with its section forces `cut`, without stresses (see finish_stations()).
StationCut make_station(const StaticSystem& system, const LineState& state, const CutForces& cut, int element,
                        double xi);

/// Results of the equilibrium alone, without warnings and the effect of the current.
StaticResults recover_state(const Model& model, const StaticSolution& solution);

/// Results of an equilibrium without code checks, which are made from results: see checks/run_checks.h.
StaticResults recover_statics(const Model& model, const StaticSolution& solution);

}  // namespace overbend
