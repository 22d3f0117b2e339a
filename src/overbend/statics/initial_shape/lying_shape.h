/// Line lying straight on the bed.
#pragma once

#include <vector>

#include "model/model.h"
#include "system/line.h"

namespace overbend {

/// Shape of a line (six per node, as LineState::q) along the bed: through `place` at its arc length `s`, in the
/// horizontal `direction` (unit vector) with increasing arc length. Its penetration supports its weight; a buoyant
/// line touches the bed.
std::vector<double> lying_shape(const Model& model, const Line& line, const Vec3& place, const Vec3& direction,
                                double s);

/// Same for a line that is straight and level at the height of `place`.
std::vector<double> level_shape(const Line& line, const Vec3& place, const Vec3& direction, double s);

}  // namespace overbend
