/// Initial shape of a line dragged along the bed: the part on the bed, and the free cable up to its winch.
#pragma once

#include "statics/initial_shape/lay_shape.h"

namespace overbend {

/// Returns the axis of the fixed end of the cable at its winch, frame W [m].
Vec3 winch_place(const Model& model, const LayPlane& plane);

/// Continues from `landed`, a line that is suspended down to the bed: along the bed with dT/ds = w (mu cos a + sin a),
/// the friction against the motion, up to the point from which a cable leaving the bed tangentially rises to the winch.
/// If pipe and head are not suspended clear of the bed, `landed` is recomputed including the pipe's bending stiffness.
LayShape dragged_shape(const Model& model, const LayPlane& plane, double tension, LayShape landed);

}  // namespace overbend
