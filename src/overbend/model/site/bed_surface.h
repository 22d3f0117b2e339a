/// The surface of the sea bed as functions of the place: a plane, or a shape over it. Kernels take the plane's numbers
/// or the shape's address; nothing else outside asks how it is made.
#pragma once

#include <memory>

#include "base/vec.h"

namespace overbend {

struct BedShape;

class BedSurface {
 public:
  /// Level at z = 0.
  BedSurface() = default;
  /// Through a point, with the upward unit normal `normal_W`.
  BedSurface(const Vec3& point_W, const Vec3& normal_W) : normal_W_(normal_W), offset_(normal_W.dot(point_W)) {}
  /// With the heights of a shape; `level` is the height of the level bed that stands for it where only a level one
  /// serves.
  BedSurface(std::shared_ptr<const BedShape> shape, double level) : offset_(level), shape_(std::move(shape)) {}

  /// Height over mean water level [m].
  double height(double x, double y) const {
    if (shape_) return shaped_height(x, y);
    return (offset_ - normal_W_.x() * x - normal_W_.y() * y) / normal_W_.z();
  }
  /// Upward unit normal, W.
  Vec3 normal(double x, double y) const { return shape_ ? shaped_normal(x, y) : normal_W_; }
  /// Height of a point over the bed times the cosine of the slope under it: its distance from the tangent plane there,
  /// negative inside the bed [m].
  double clearance(const Vec3& p_W) const {
    if (shape_) return (p_W.z() - shaped_height(p_W.x(), p_W.y())) * shaped_normal(p_W.x(), p_W.y()).z();
    return normal_W_.dot(p_W) - offset_;
  }
  /// Rise per metre in a horizontal direction [-].
  double slope(double x, double y, const Vec3& direction_W) const;
  /// Unit vector on the bed under a point: the part of a direction that lies in the tangent plane.
  Vec3 along(const Vec3& p_W, const Vec3& direction_W) const;

  /// normal . point of the plane, for kernels, which compute `clearance` themselves [m].
  double offset() const { return offset_; }
  /// Normal of the plane, likewise.
  const Vec3& plane_normal() const { return normal_W_; }
  /// Null for a plane.
  const BedShape* shape() const { return shape_.get(); }

 private:
  double shaped_height(double x, double y) const;
  Vec3 shaped_normal(double x, double y) const;

  Vec3 normal_W_ = Vec3::UnitZ();
  double offset_ = 0.0;
  std::shared_ptr<const BedShape> shape_;
};

}  // namespace overbend
