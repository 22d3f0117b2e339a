/// Cable of a line dragged along the bed; its length follows from the position of its winch.
#pragma once

#include <optional>

#include "statics/solver/continuation.h"
#include "statics/solver/statics.h"

namespace overbend {

/// From an equilibrium with the target tension, changes the unstressed length of the cable until its end is at the
/// winch, keeping the tension. No effect on lines that are not dragged. Returns false if no equilibrium is found on the
/// way. The mesh keeps its nodes; the spacing of the cable's nodes changes.
bool fit_cable_to_winch(EquilibriumProblem& problem, const LoadHistory& past);

/// Returns a failure if a dragged line is in compression, or needs more cable than the winch has. nullopt for other
/// lines.
std::optional<StaticFailure> check_dragged(EquilibriumProblem& problem);

}  // namespace overbend
