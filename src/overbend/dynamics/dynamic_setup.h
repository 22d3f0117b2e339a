/// From a model and its static equilibrium to a line in motion.
#pragma once

#include "mechanics/restitution.h"
#include "statics/statics.h"
#include "system/dynamic_line.h"

namespace overbend {

/// Rollers of the supports in the vessel's frame with their laws.
///
/// Damping follows from the coefficient of restitution and the mass that an impact moves (impact_mass.h), with added
/// mass under water, against a rigid roller ([silva2009] equations 16 to 18; Schwager & Poeschel 2007 for contacts that
/// never pull, or the textbook's formula, as the roller asks). Tangential stiffness, where the roller has none of its
/// own, is a tenth of the normal one.
std::vector<MovingRoller> moving_rollers(const Model& model, const std::vector<PlacedRoller>& placed);

/// The machine as the model sets it. Without a tension of its own it wants that of the equilibrium; without an
/// acceleration it gathers speed in half a second, for a speed at once would strike the pipe with a wave of
/// velocity * sqrt(EA m).
TensionerLaw tensioner_law(const TensionerDescription& tensioner, double static_tension);

/// Everything but what depends on time: `surroundings` is left to the caller.
DynamicLine dynamic_line(const Model& model, const StaticSolution& solution);

/// The equilibrium as a state at rest at `time`: the bed's friction stretched as statics left it, accelerations zero.
DynamicState static_state(const DynamicLine& line, const StaticSolution& solution, double time);

}  // namespace overbend
