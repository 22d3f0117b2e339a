/// What friction decides: the answers between which an equilibrium lies, docs/theory/roller-friction.md.
#pragma once

#include "results/static_results.h"
#include "statics/solver/statics.h"

namespace overbend {

/// Solves the limits of the friction that the model gives and puts them into `results.roller_friction`, each from
/// `solution`: rollers without friction and with all of it along the pipe one way and the other, all of it across one
/// way and the other, and, of a pipe laid steadily under a side load, the pipe pulled across after it was laid. A limit
/// without an equilibrium is left out with a warning.
void find_friction_cases(const Model& model, const StaticSolution& solution, StaticResults& results);

/// What an equilibrium has to tell of a limit.
RollerFrictionCase friction_case(const std::string& name, const StaticResults& results);

}  // namespace overbend
