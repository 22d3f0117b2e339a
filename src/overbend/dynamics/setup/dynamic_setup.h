/// From a model and its static equilibrium to a system in motion.
#pragma once

#include "statics/solver/statics.h"
#include "system/assembly.h"

namespace overbend {

/// The machine as the model sets it. Without a tension of its own it wants that of the equilibrium; without an
/// acceleration it gathers speed in half a second, for a speed at once would strike the pipe with a wave of
/// velocity * sqrt(EA m).
TensionerLaw tensioner_law(const TensionerDescription& tensioner, double static_tension);

/// The pipe on its vessel: held by the tensioner, its far end where statics put it. `surroundings` is left to the
/// caller.
System pipe_system(const Model& model, const StaticSolution& solution, double static_tension);

/// Puts memories of the pipe's equilibrium into its state at rest: what its steel has been through, the bed's friction
/// stretched as statics left it.
void lay_at_rest(const Line& line, const StaticSolution& solution, LineState& pipe);

}  // namespace overbend
