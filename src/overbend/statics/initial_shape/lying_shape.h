/// A line that lies straight on the bed.
#pragma once

#include <vector>

#include "model/model.h"
#include "system/line.h"

namespace overbend {

/// Shape of a line (six per node, as LineState::q) along the bed: through `place` at its arc length `s`, its direction
/// with growing arc length the horizontal unit vector `way`. It sinks in by what bears its weight; where it floats it
/// touches the bed.
std::vector<double> lying_shape(const Model& model, const Line& line, const Vec3& place, const Vec3& way, double s);

/// The same of one that is straight and level at the height of `place`.
std::vector<double> level_shape(const Line& line, const Vec3& place, const Vec3& way, double s);

}  // namespace overbend
