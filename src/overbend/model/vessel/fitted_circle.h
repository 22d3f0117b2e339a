/// Radius of a ramp or stinger, fitted to the positions of its boxes.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "model/vessel/supports.h"

namespace overbend {

/// Returns the radius of the least-squares circle through the points, (X, Z) in the frame of the boxes [m]. Empty with
/// fewer than three points, and if they are on no arc that bends down: on a line, or with the centre above.
std::optional<double> fitted_radius(const std::vector<Eigen::Vector2d>& points);

/// The same for the boxes of a structure, without their offsets, with stinger sections at their current angles.
std::optional<double> fitted_radius(const Supports& supports, Structure structure);

}  // namespace overbend
