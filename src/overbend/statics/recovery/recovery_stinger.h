/// What is told of a stinger on hinges at rest.
#pragma once

#include "results/static_results.h"
#include "statics/solver/statics.h"

namespace overbend {

/// Angle, hinge force, stop and tanks of each section; `system` is evaluated at the solution. Adds what is to be
/// warned of.
void recover_stinger(StaticResults& results, const StaticSystem& system, const StaticSolution& solution);

}  // namespace overbend
