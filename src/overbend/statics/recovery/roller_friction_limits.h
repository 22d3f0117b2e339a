/// Effect of roller friction: bounds of the equilibrium, docs/theory/roller-friction.md.
#pragma once

#include "results/static_results.h"
#include "statics/solver/statics.h"

namespace overbend {

/// Solves the limits of the model's friction, each with a warm start from `solution`, and stores them in
/// `results.roller_friction`: rollers without friction; full axial friction in both directions; full lateral friction
/// in both directions; and, for steady laying under a side load, the pipe pulled across after laying. A limit without
/// an equilibrium is omitted with a warning.
void find_roller_friction_limits(const Model& model, const StaticSolution& solution, StaticResults& results);

/// Results of a limit.
RollerFrictionCase friction_case(const std::string& name, const StaticResults& results);

}  // namespace overbend
