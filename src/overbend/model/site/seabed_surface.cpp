#include "model/site/seabed_surface.h"

#include "model/site/seabed_shape.h"

namespace overbend {

double SeabedSurface::shaped_height(double x, double y) const {
  return bed_point(*shape_, x, y).z;
}

Vec3 SeabedSurface::shaped_normal(double x, double y) const {
  const SeabedPoint point = bed_point(*shape_, x, y);
  return Vec3(-point.zx, -point.zy, 1.0).normalized();
}

double SeabedSurface::slope(double x, double y, const Vec3& direction_W) const {
  const Vec3 n = normal(x, y);
  return -(n.x() * direction_W.x() + n.y() * direction_W.y()) / n.z();
}

Vec3 SeabedSurface::along(const Vec3& p_W, const Vec3& direction_W) const {
  const Vec3 n = normal(p_W.x(), p_W.y());
  return (direction_W - direction_W.dot(n) * n).normalized();
}

}  // namespace overbend
