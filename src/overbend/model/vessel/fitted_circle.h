/// The circle that a ramp or stinger is bent to, from the places of its boxes.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "model/vessel/supports.h"

namespace overbend {

/// Radius of the circle with the least sum of squared distances to the points, (X, Z) in the frame of the boxes [m].
/// Empty with fewer than three points, and where they lie on no arc that bends down: on a line, or with the centre
/// above.
std::optional<double> fitted_radius(const std::vector<Eigen::Vector2d>& points);

/// The same of the coordinates of a structure's boxes, without their offsets, sections of a stinger as they are turned.
std::optional<double> fitted_radius(const Supports& supports, Structure structure);

}  // namespace overbend
