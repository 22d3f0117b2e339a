/// Statics of a line of given length with its far end at a given distance, in place of a given tension.
#pragma once

#include "statics/solver/statics.h"

namespace overbend {

/// True if the model gives pipe.length and pipe.anchor in place of a tension, and the line contains no cable.
bool is_anchored(const Model& model);

/// Finds the tension at the tensioner with which the far end is at the distance of pipe.anchor, by a bracketed secant
/// search over lays of given tension and the same length, on the same branch of equilibria as a lay of given tension.
/// The distance increases with the tension. Fails if the anchor is nearer than at zero bottom tension, or too far for
/// the line to touch the seabed.
StaticOutcome solve_anchored(const Model& model, const LoadHistory& past);

}  // namespace overbend
