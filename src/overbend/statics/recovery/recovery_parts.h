/// Parts of recover_statics (statics/recovery/recovery.h), for solvers of many neighbouring lays.
#pragma once

#include "results/static_results.h"
#include "statics/solver/statics.h"

namespace overbend {

/// Results with warnings but without the effect of the current (statics/recovery/current_effect.h).
StaticResults recover_in_current(const Model& model, const StaticSolution& solution);

/// Stations only, as from recover_state.
std::vector<Station> recover_stations(const Model& model, const StaticSolution& solution);

}  // namespace overbend
