/// Seabed surface as a function of position: a plane, or a shape over it. Kernels use the plane's numbers or the
/// shape's address; all other code uses these functions.
#pragma once

#include <memory>

#include "base/vec.h"

namespace overbend {

struct SeabedShape;

class SeabedSurface {
 public:
  /// Level surface at z = 0.
  SeabedSurface() = default;
  /// Plane through a point, with the upward unit normal `normal_W`.
  SeabedSurface(const Vec3& point_W, const Vec3& normal_W) : normal_W_(normal_W), offset_(normal_W.dot(point_W)) {}
  /// Surface with the heights of a shape; `level` is the height of the equivalent level seabed for methods that need
  /// one.
  SeabedSurface(std::shared_ptr<const SeabedShape> shape, double level) : offset_(level), shape_(std::move(shape)) {}

  /// Height above mean water level [m].
  double height(double x, double y) const {
    if (shape_) return shaped_height(x, y);
    return (offset_ - normal_W_.x() * x - normal_W_.y() * y) / normal_W_.z();
  }
  /// Upward unit normal, W.
  Vec3 normal(double x, double y) const { return shape_ ? shaped_normal(x, y) : normal_W_; }
  /// Height of a point above the seabed times the cosine of the slope under it: its distance from the tangent plane,
  /// negative inside the seabed [m].
  double clearance(const Vec3& p_W) const {
    if (shape_) return (p_W.z() - shaped_height(p_W.x(), p_W.y())) * shaped_normal(p_W.x(), p_W.y()).z();
    return normal_W_.dot(p_W) - offset_;
  }
  /// Rise per metre in a horizontal direction [-].
  double slope(double x, double y, const Vec3& direction_W) const;
  /// Unit vector on the seabed under a point: projection of a direction onto the tangent plane.
  Vec3 along(const Vec3& p_W, const Vec3& direction_W) const;

  /// normal . point of the plane, for kernels, which compute `clearance` themselves [m].
  double offset() const { return offset_; }
  /// Normal of the plane, for kernels.
  const Vec3& plane_normal() const { return normal_W_; }
  /// Null for a plane.
  const SeabedShape* shape() const { return shape_.get(); }

 private:
  double shaped_height(double x, double y) const;
  Vec3 shaped_normal(double x, double y) const;

  Vec3 normal_W_ = Vec3::UnitZ();
  double offset_ = 0.0;
  std::shared_ptr<const SeabedShape> shape_;
};

}  // namespace overbend
