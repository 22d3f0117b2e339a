/// Initial shape of a line with a cable in it: over the supports, then down as a chain of its sections.
#pragma once

#include "statics/initial_shape/lay_shape.h"

namespace overbend {

/// Shape of the line of an operation stage under `tension` at the top [N]: over the supports that bend it, then a chain
/// without bending stiffness, whose weight changes with its sections, to the bed, or to the height of an anchor at
/// which it ends. LayShape::problem gives the reason if there is none.
LayShape stage_shape(const Model& model, const LayPlane& plane, double tension);

/// Minimum top tension at which the line of a stage, vertical below the last support, reaches the bed or its anchor's
/// height: the work of the weight per length from the tensioner down to there [N].
double min_stage_top_tension(const Model& model, const LayPlane& plane);

/// Height at which a cable fixes the far end [m].
double pinned_height(const Model& model);

}  // namespace overbend
