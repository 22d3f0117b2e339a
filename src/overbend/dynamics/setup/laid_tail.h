/// Laid pipe behind the anchor end of a static solution, for dynamics.
#pragma once

#include "statics/solver/statics.h"

namespace overbend {

/// Maximum length of the added pipe [m].
inline constexpr double kMaxTailLength = 3000.0;

/// Returns the friction anchorage length T/(mu w) [m]: length of laid pipe behind touchdown over which axial friction
/// takes up a tension change as large as the tension at the tensioner. If the pipe is anchored closer, the dynamic
/// tension at the tensioner is too large, because the laid pipe beyond would have moved. Infinite on a seabed without
/// axial friction.
double friction_anchorage_length(const Model& model, double top_tension);

/// Returns `solution` with the laid pipe extended straight along the seabed until `reach` times that length lies behind
/// its anchor end, at most `kMaxTailLength`; the arc length of the added pipe is negative. Elements grow to tens of
/// metres: only axial strain travels along the laid pipe. On a slope it lies as in statics, with less strain at greater
/// depth; a rising seabed ends it before it leaves the water. Unchanged if the model gives the pipe's length (its
/// anchor is real) and on a seabed without axial friction, where no length would suffice.
StaticSolution with_laid_tail(const Model& model, const StaticSolution& solution, double top_tension, double reach);

}  // namespace overbend
