/// Whether ramp and stinger can be meant as the model has them.
#pragma once

#include <optional>

#include "statics/initial_shape/lay_shape.h"
#include "statics/solver/statics.h"

namespace overbend {

/// Names the box that no pipe can be meant to pass: farther from the tensioner than any stinger reaches, or such that
/// the line from the tensioner over the middles of the boxes turns by more than a right angle, least without it, and
/// far off that line. Such places come from a slip (mm read as m, a digit too many); a box that merely stands proud is
/// left to the solution.
std::optional<StaticFailure> misplaced_box(const Model& model, const LayPlane& plane);

}  // namespace overbend
