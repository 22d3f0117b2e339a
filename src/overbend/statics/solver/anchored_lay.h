/// Statics of a line of given length whose far end lies at a given distance, in place of a given tension.
#pragma once

#include "statics/solver/statics.h"

namespace overbend {

/// Whether the model gives pipe.length and pipe.anchor in place of a tension, and no cable is in the line.
bool is_anchored(const Model& model);

/// Finds the tension at the tensioner with which the far end lies at the distance of pipe.anchor, by a bracketed secant
/// search over lays of given tension and the same length: the branch of equilibria is that of a lay whose tension is
/// given. The distance grows with the tension. Fails where the anchor is nearer than with zero bottom tension, or too
/// far for the line to touch the seabed.
StaticOutcome solve_anchored(const Model& model, const LinePast& past);

}  // namespace overbend
