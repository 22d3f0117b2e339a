/// First guess of a line with a cable in it: over the supports, then down as a chain of the sections that hang there.
#pragma once

#include "statics/initial_shape/lay_shape.h"

namespace overbend {

/// The line of a stage of an operation, held at the top with `tension` [N]. Over the supports that it bends down over,
/// then a chain without bending stiffness, whose weight changes with its sections, to the bed; or, where it ends at an
/// anchor before it lies, to the height of that. LayShape::problem says where there is none.
LayShape stage_shape(const Model& model, const LayPlane& plane, double tension);

/// The tension at the top below which the line of a stage hangs plumb from the last support and still does not reach
/// the bed or its anchor's height: the work of the weight per length from the tensioner down to there [N].
double least_stage_tension(const Model& model, const LayPlane& plane);

/// Height at which the far end is pinned by a cable [m].
double pinned_height(const Model& model);

}  // namespace overbend
