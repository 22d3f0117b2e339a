/// Parts of recover_statics (statics/recovery/recovery.h), for who solves many lays close to each other.
#pragma once

#include "results/static_results.h"
#include "statics/solver/statics.h"

namespace overbend {

/// Results with what is warned of, but without what the current adds (statics/recovery/current_effect.h).
StaticResults recover_in_current(const Model& model, const StaticSolution& solution);

/// The stations alone, as recover_state makes them.
std::vector<Station> recover_stations(const Model& model, const StaticSolution& solution);

}  // namespace overbend
