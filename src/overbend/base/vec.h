/// Small fixed-size vectors used everywhere.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace overbend {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

}  // namespace overbend
