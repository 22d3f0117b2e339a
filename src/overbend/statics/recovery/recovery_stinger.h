/// Results of a hinged stinger in equilibrium.
#pragma once

#include "results/static_results.h"
#include "statics/solver/statics.h"

namespace overbend {

/// Adds angle, hinge force, stop and tanks of each section, and warnings. `system` is evaluated at the solution.
void recover_stinger(StaticResults& results, const StaticSystem& system, const StaticSolution& solution);

}  // namespace overbend
