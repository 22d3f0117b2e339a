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

/// The equilibrium as a state at rest at `time`: the bed's friction stretched as statics left it, accelerations zero.
/// `moorings`: first shapes of the lines behind the pipe.
SystemState static_state(const System& system, const StaticSolution& solution,
                         const std::vector<std::vector<double>>& moorings, double time);

}  // namespace overbend
