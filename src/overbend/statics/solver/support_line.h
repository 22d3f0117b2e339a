/// Plausibility of the positions of ramp and stinger.
#pragma once

#include <optional>

#include "statics/initial_shape/lay_shape.h"
#include "statics/solver/statics.h"

namespace overbend {

/// Returns a failure that names a box no pipe can pass: farther from the tensioner than any stinger reaches, or a box
/// whose removal straightens the line from the tensioner over the boxes most, where that line turns by more than a
/// right angle, and far off it. Such positions are typing errors (mm read as m, an extra digit); a box that is merely
/// high is left to the solution.
std::optional<StaticFailure> misplaced_box(const Model& model, const LayPlane& plane);

}  // namespace overbend
