#include "mechanics/ground.h"

#include <cmath>

#include "model/site/seabed_shape.h"

namespace overbend {
namespace {

Vec3 to_vector(const double (&v)[3]) {
  return {v[0], v[1], v[2]};
}

double over_flat_bed(const LineEnvironment& env, const Vec3& r) {
  return to_vector(env.bed_normal).dot(r) - env.bed_offset;
}

/// As in mechanics/line_kernel_ground.h.
void put_shape(GroundPoint& ground, const LineEnvironment& env, const Vec3& r) {
  const SeabedPoint bed = bed_point(*env.bed_shape, r.x(), r.y());
  const double over = r.z() - (env.bed_level + env.bed_relief * (bed.z - env.bed_level));
  const Vec3 slope = env.bed_relief * Vec3(bed.zx, bed.zy, 0.0);
  Mat3 bend = Mat3::Zero();
  bend.topLeftCorner<2, 2>() << bed.zxx, bed.zxy, bed.zxy, bed.zyy;
  bend *= env.bed_relief;
  const double c = 1.0 / std::sqrt(1.0 + slope.squaredNorm());
  const Vec3 by_place = -c * c * c * bend * slope;
  ground.normal = c * (Vec3::UnitZ() - slope);
  ground.clearance = c * over + env.bed_lowered;
  ground.gradient = ground.normal + over * by_place;
  ground.turn = (Vec3::UnitZ() - slope) * by_place.transpose() - c * bend;
}

/// Nearest point of a route with arcs; see line_kernel_ground.h.
void put_bent_route(GroundPoint& ground, const LineEnvironment& env, const Vec3& r) {
  const RoutePiece* piece = env.route;
  while (piece + 1 < env.route + env.route_pieces &&
         (r.x() - piece[1].x) * piece[1].tx + (r.y() - piece[1].y) * piece[1].ty >= 0.0) {
    ++piece;
  }
  const Vec3 port(piece->ty, -piece->tx, 0.0);
  const Vec3 from(r.x() - piece->x, r.y() - piece->y, 0.0);
  ground.across_route = port;
  ground.off_route = from.dot(port) - env.route_shift;
  if (piece->curvature != 0.0) {
    const double radius = 1.0 / piece->curvature, side = std::copysign(1.0, radius);
    const Vec3 from_centre = from - radius * port;
    ground.across_route = -side * from_centre.normalized();
    ground.off_route = radius - side * from_centre.norm() - env.route_shift;
  }
  const Vec3 level(-ground.across_route.y(), ground.across_route.x(), 0.0);
  ground.along_route = (level - ground.normal.dot(level) * ground.normal).normalized();
}

}  // namespace

double bed_clearance(const LineEnvironment& env, const Vec3& r) {
  if (env.bed_shape == nullptr) return over_flat_bed(env, r);
  GroundPoint ground;
  put_shape(ground, env, r);
  return ground.clearance;
}

GroundPoint ground_at(const LineEnvironment& env, const Vec3& r) {
  GroundPoint ground;
  ground.normal = to_vector(env.bed_normal);
  ground.clearance = over_flat_bed(env, r);
  ground.gradient = ground.normal;
  if (env.bed_shape != nullptr) put_shape(ground, env, r);
  ground.across_route = to_vector(env.route_normal);
  ground.off_route = ground.across_route.dot(r) - env.route_offset;
  ground.along_route = to_vector(env.bed_along);
  if (env.bed_shape != nullptr) {
    const Vec3 ahead = Vec3::UnitZ().cross(ground.across_route);
    ground.along_route = (ahead - ahead.dot(ground.normal) * ground.normal).normalized();
  }
  if (env.route_pieces > 0) put_bent_route(ground, env, r);
  return ground;
}

Mat3 along_route_turn(const GroundPoint& ground) {
  const Vec3 ahead = Vec3::UnitZ().cross(ground.across_route);
  const double into = ahead.dot(ground.normal);
  const Mat3 flat = -ground.normal * (ahead.transpose() * ground.turn) - into * ground.turn;
  return (flat - ground.along_route * (ground.along_route.transpose() * flat)) / (ahead - into * ground.normal).norm();
}

}  // namespace overbend
