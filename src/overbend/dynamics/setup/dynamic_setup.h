/// System in motion from a model and its static equilibrium.
#pragma once

#include "statics/solver/statics.h"
#include "system/assembly.h"

namespace overbend {

/// Returns the law of the model's tensioner. Default target tension: that of the equilibrium. Default acceleration:
/// full speed in half a second, because an immediate speed would load the pipe with a wave of velocity * sqrt(EA m).
TensionerLaw tensioner_law(const TensionerDescription& tensioner, double static_tension);

/// Returns the pipe on its vessel: held by the tensioner, its anchor end at the static position. The caller sets
/// `surroundings`.
System pipe_system(const Model& model, const StaticSolution& solution, double static_tension);

/// Sets the memories of the pipe's equilibrium in its state at rest: plastic history and static stretch of the seabed
/// friction.
void set_initial_memories(const Line& line, const StaticSolution& solution, LineState& pipe);

}  // namespace overbend
