/// The laid pipe behind the far end of a static solution, for motion.
#pragma once

#include "statics/solver/statics.h"

namespace overbend {

/// Longest tail that is added [m].
inline constexpr double kLongestTail = 3000.0;

/// Length of laid pipe behind touchdown over which axial friction takes up a change of tension as large as the tension
/// at the tensioner [m]: T/(mu w). Where it is anchored no further away, a run's tension at the tensioner is too large
/// by what the laid pipe beyond would have given way. Infinite on a bed without axial friction.
double tail_to_hold(const Model& model, double top_tension);

/// `solution` with the laid pipe carried on straight along the bed until `reach` times that length lies behind its far
/// end, `kLongestTail` at most; arc length of what is added is negative. Elements grow to tens of metres: on the bed
/// only stretch travels along them. On a slope it lies as statics have it, less stretched the deeper it lies; a bed
/// that rises ends it before it leaves the water. Unchanged where the model gives the pipe's length (its anchor is
/// real) and on a bed without axial friction, where no length would do.
StaticSolution with_laid_tail(const Model& model, const StaticSolution& solution, double top_tension, double reach);

}  // namespace overbend
