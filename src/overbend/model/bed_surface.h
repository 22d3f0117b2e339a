/// The surface of the sea bed as functions of the place. Today it is a plane; nothing outside asks how it is made but
/// the kernels, which take its numbers.
#pragma once

#include "base/vec.h"

namespace overbend {

class BedSurface {
 public:
  /// Level at z = 0.
  BedSurface() = default;
  /// Through a point, with the upward unit normal `normal_W`.
  BedSurface(const Vec3& point_W, const Vec3& normal_W) : normal_W_(normal_W), offset_(normal_W.dot(point_W)) {}

  /// Height over mean water level [m].
  double height(double x, double y) const { return (offset_ - normal_W_.x() * x - normal_W_.y() * y) / normal_W_.z(); }
  /// Upward unit normal, W.
  const Vec3& normal(double /*x*/, double /*y*/) const { return normal_W_; }
  /// Height of a point over the bed times the cosine of the slope under it: its distance from the tangent plane there,
  /// negative inside the bed [m].
  double clearance(const Vec3& p_W) const { return normal_W_.dot(p_W) - offset_; }
  /// Rise per metre in a horizontal direction [-].
  double slope(double x, double y, const Vec3& direction_W) const;
  /// Unit vector on the bed under a point: the part of a direction that lies in the tangent plane.
  Vec3 along(const Vec3& p_W, const Vec3& direction_W) const;

  /// normal . point of the bed, for kernels, which compute `clearance` themselves [m].
  double offset() const { return offset_; }

 private:
  Vec3 normal_W_ = Vec3::UnitZ();
  double offset_ = 0.0;
};

}  // namespace overbend
