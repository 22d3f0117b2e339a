#include "mechanics/ground.h"

#include <cmath>

#include "model/site/bed_shape.h"

namespace overbend {
namespace {

Vec3 vector_of(const double (&v)[3]) {
  return {v[0], v[1], v[2]};
}

double over_flat_bed(const LineEnvironment& env, const Vec3& r) {
  return vector_of(env.bed_normal).dot(r) - env.bed_offset;
}

/// As in mechanics/line_kernel_ground.h.
void put_shape(GroundPoint& at, const LineEnvironment& env, const Vec3& r) {
  const BedPoint bed = bed_point(*env.bed_shape, r.x(), r.y());
  const double over = r.z() - (env.bed_level + env.bed_relief * (bed.z - env.bed_level));
  const Vec3 slope = env.bed_relief * Vec3(bed.zx, bed.zy, 0.0);
  Mat3 bend = Mat3::Zero();
  bend.topLeftCorner<2, 2>() << bed.zxx, bed.zxy, bed.zxy, bed.zyy;
  bend *= env.bed_relief;
  const double c = 1.0 / std::sqrt(1.0 + slope.squaredNorm());
  const Vec3 by_place = -c * c * c * bend * slope;
  at.normal = c * (Vec3::UnitZ() - slope);
  at.clearance = c * over + env.bed_lowered;
  at.gradient = at.normal + over * by_place;
  at.turn = (Vec3::UnitZ() - slope) * by_place.transpose() - c * bend;
}

/// The route beside a point, of one with arcs; see line_kernel_ground.h.
void put_bent_route(GroundPoint& at, const LineEnvironment& env, const Vec3& r) {
  const RoutePiece* piece = env.route;
  while (piece + 1 < env.route + env.route_pieces &&
         (r.x() - piece[1].x) * piece[1].tx + (r.y() - piece[1].y) * piece[1].ty >= 0.0) {
    ++piece;
  }
  const Vec3 port(piece->ty, -piece->tx, 0.0);
  const Vec3 from(r.x() - piece->x, r.y() - piece->y, 0.0);
  at.across_route = port;
  at.off_route = from.dot(port) - env.route_shift;
  if (piece->curvature != 0.0) {
    const double radius = 1.0 / piece->curvature, side = std::copysign(1.0, radius);
    const Vec3 from_centre = from - radius * port;
    at.across_route = -side * from_centre.normalized();
    at.off_route = radius - side * from_centre.norm() - env.route_shift;
  }
  const Vec3 level(-at.across_route.y(), at.across_route.x(), 0.0);
  at.along_route = (level - at.normal.dot(level) * at.normal).normalized();
}

}  // namespace

double bed_clearance(const LineEnvironment& env, const Vec3& r) {
  if (env.bed_shape == nullptr) return over_flat_bed(env, r);
  GroundPoint at;
  put_shape(at, env, r);
  return at.clearance;
}

GroundPoint ground_at(const LineEnvironment& env, const Vec3& r) {
  GroundPoint at;
  at.normal = vector_of(env.bed_normal);
  at.clearance = over_flat_bed(env, r);
  at.gradient = at.normal;
  if (env.bed_shape != nullptr) put_shape(at, env, r);
  at.across_route = vector_of(env.route_normal);
  at.off_route = at.across_route.dot(r) - env.route_offset;
  at.along_route = vector_of(env.bed_along);
  if (env.bed_shape != nullptr) {
    const Vec3 ahead = Vec3::UnitZ().cross(at.across_route);
    at.along_route = (ahead - ahead.dot(at.normal) * at.normal).normalized();
  }
  if (env.route_pieces > 0) put_bent_route(at, env, r);
  return at;
}

Mat3 along_route_turn(const GroundPoint& at) {
  const Vec3 ahead = Vec3::UnitZ().cross(at.across_route);
  const double into = ahead.dot(at.normal);
  const Mat3 flat = -at.normal * (ahead.transpose() * at.turn) - into * at.turn;
  return (flat - at.along_route * (at.along_route.transpose() * flat)) / (ahead - into * at.normal).norm();
}

}  // namespace overbend
