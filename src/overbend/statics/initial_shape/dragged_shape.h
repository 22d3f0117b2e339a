/// First guess of a line dragged along the bed: what lies there, and the free cable up to its winch.
#pragma once

#include "statics/initial_shape/lay_shape.h"

namespace overbend {

/// Axis of the fixed end of the cable at its winch, frame W [m].
Vec3 winch_place(const Model& model, const LayPlane& plane);

/// Goes on from `landed`, a line that hangs down to the bed: along the bed with dT/ds = w (mu cos a + sin a), the
/// friction against the motion, up to where a cable that leaves the bed along it rises to the winch. Where pipe and
/// head do not hang clear of the bed, `landed` is made anew with the pipe's bending stiffness in mind.
LayShape dragged_shape(const Model& model, const LayPlane& plane, double tension, LayShape landed);

}  // namespace overbend
