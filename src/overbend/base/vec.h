/// Small fixed-size vectors used everywhere.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace overbend {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

/// [a]x: the matrix of the cross product a x.
inline Mat3 cross_matrix(const Vec3& a) {
  Mat3 m;
  m << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
  return m;
}

}  // namespace overbend
