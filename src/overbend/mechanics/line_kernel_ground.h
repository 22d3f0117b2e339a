/// Seabed and route under a batch of points, for all of the kernel. For line_kernel.cpp only.
///
/// A plane is the fast path. For a seabed with bathymetry, gap and normal are those of the tangent plane at the same x
/// and y: clearance = (z - z_bed) cos(slope), normal = (-dz_bed/dx, -dz_bed/dy, 1) cos(slope). The gradient of the
/// clearance therefore differs slightly from the normal, and the normal varies with position.
#pragma once

#include "mechanics/line_kernel_batch.h"
#include "mechanics/soil_law.h"

namespace overbend {

/// Height of the seabed at a position and its derivatives, see model/site/seabed_shape.h.
void bed_values(const SeabedShape* shape, double x, double y, double* six);

}  // namespace overbend

namespace overbend::OVERBEND_ISA_NAMESPACE {
namespace {

/// Columns of a derivative with position that does not depend on z.
struct LevelColumns {
  Vec in_x, in_y;
};

struct SeabedUnder {
  Vec normal;
  Lanes clearance;    ///< Distance of the axis from the seabed, along its normal [m].
  Vec gradient;       ///< Gradient of the clearance; for a plane its normal.
  LevelColumns turn;  ///< Derivative of the normal; only set for bathymetry, as are values derived from it.
};

/// Evaluates one lane over bathymetry.
inline void put_shape_under(SeabedUnder& under, int l, const LineEnvironment& env, const Vec& r) {
  double v[6];
  bed_values(env.bed_shape, r.x[l], r.y[l], v);
  const double over = r.z[l] - (env.bed_level + env.bed_relief * (v[0] - env.bed_level));
  const double zx = env.bed_relief * v[1], zy = env.bed_relief * v[2];
  const double zxx = env.bed_relief * v[3], zxy = env.bed_relief * v[4], zyy = env.bed_relief * v[5];
  const double c = 1.0 / __builtin_sqrt(1.0 + zx * zx + zy * zy), c3 = c * c * c;
  const double cx = -c3 * (zx * zxx + zy * zxy), cy = -c3 * (zx * zxy + zy * zyy);
  under.normal.x[l] = -c * zx;
  under.normal.y[l] = -c * zy;
  under.normal.z[l] = c;
  under.clearance[l] = over * c + env.bed_lowered;
  under.gradient.x[l] = -c * zx + over * cx;
  under.gradient.y[l] = -c * zy + over * cy;
  under.gradient.z[l] = c;
  under.turn.in_x.x[l] = -zx * cx - c * zxx;
  under.turn.in_x.y[l] = -zy * cx - c * zxy;
  under.turn.in_x.z[l] = cx;
  under.turn.in_y.x[l] = -zx * cy - c * zxy;
  under.turn.in_y.y[l] = -zy * cy - c * zyy;
  under.turn.in_y.z[l] = cy;
}

/// Seabed under points. Points that cannot touch the shape, given the pipe's radius, get a large clearance.
inline __attribute__((noinline)) SeabedUnder shape_under(const LineEnvironment& env, const Vec& r,
                                                         const Lanes& radius) {
  SeabedUnder under{{Lanes{}, Lanes{}, all(1.0)}, r.z - env.bed_highest, {Lanes{}, Lanes{}, all(1.0)}, LevelColumns{}};
  if (!any(radius - under.clearance)) {
    return under;
  }
  for (int l = 0; l < kWidth; ++l) {
    if (under.clearance[l] < radius[l]) {
      put_shape_under(under, l, env, r);
    }
  }
  return under;
}

inline Vec plane_normal(const LineEnvironment& env) {
  return {all(env.bed_normal[0]), all(env.bed_normal[1]), all(env.bed_normal[2])};
}

inline SeabedUnder bed_under(const LineEnvironment& env, const Vec& r, const Lanes& radius) {
  if (env.bed_shape != nullptr) return shape_under(env, r, radius);
  const Vec n = plane_normal(env);
  return {n, dot(n, r) - env.bed_offset, n, LevelColumns{}};
}

/// True if any point may touch the seabed: most lines are clear of it and skip the rest.
inline bool near_bed(const LineEnvironment& env, const Vec& r, const Lanes& radius) {
  return any(env.bed_shape != nullptr ? radius - (r.z - env.bed_highest)
                                      : radius - (dot(plane_normal(env), r) - env.bed_offset));
}

/// Force per length of nonlinear soil, its derivative with penetration and its integral; laws as in
/// mechanics/soil_law.h. All 0 without contact.
struct SoilForce {
  Lanes force, slope, energy;
};

inline __attribute__((noinline)) SoilForce soil_force(const LineEnvironment& env, const Lanes& touching,
                                                      const Lanes& penetration) {
  const Lanes x = touching * penetration;
  const double k = env.bed_stiffness, bearing = env.bed_bearing;
  SoilForce soil;
  if (env.bed_soil == kHyperbolicSoil) {
    const Lanes ax = (k / bearing) * x, c = 1.0 / (1.0 + ax);
    soil.force = k * x * c;
    soil.slope = touching * (k * c * c);
    for (int l = 0; l < kWidth; ++l) {
      soil.energy[l] = bearing * bearing / k * (ax[l] - __builtin_log1p(ax[l]));
    }
    return soil;
  }
  const double knee = bearing / k, soft = kSoftSoil * k;
  const Lanes more = x > knee ? x - knee : Lanes{}, first = x - more;
  soil.force = k * first + soft * more;
  soil.slope = touching * (x > knee ? all(soft) : all(k));
  soil.energy = 0.5 * k * first * first + bearing * more + 0.5 * soft * more * more;
  return soil;
}

/// m += s times a derivative with x and y.
inline void add_columns(Mat& m, const Lanes& s, const LevelColumns& columns) {
  m.m[0][0] += s * columns.in_x.x;
  m.m[1][0] += s * columns.in_x.y;
  m.m[2][0] += s * columns.in_x.z;
  m.m[0][1] += s * columns.in_y.x;
  m.m[1][1] += s * columns.in_y.y;
  m.m[2][1] += s * columns.in_y.z;
}

/// Returns the products of the columns with a vector.
inline Vec transposed_times(const LevelColumns& columns, const Vec& v) {
  return {dot(columns.in_x, v), dot(columns.in_y, v), Lanes{}};
}

/// Point of the route nearest to a given point.
struct NearestRoutePoint {
  Vec across;       ///< Horizontal unit vector, to port.
  Lanes off;        ///< Distance of the point, to port [m].
  Lanes curvature;  ///< Curvature of the parallel line through the point, positive where it turns to port [1/m].
};

/// Nearest point of a route with arcs: the piece is the last one whose start the point has passed.
inline __attribute__((noinline)) NearestRoutePoint nearest_on_curved_route(const LineEnvironment& env, const Vec& r) {
  NearestRoutePoint route{{Lanes{}, Lanes{}, Lanes{}}, Lanes{}, Lanes{}};
  for (int l = 0; l < kWidth; ++l) {
    const RoutePiece* piece = env.route;
    for (const RoutePiece* next = piece + 1; next < env.route + env.route_pieces; ++next) {
      if ((r.x[l] - next->x) * next->tx + (r.y[l] - next->y) * next->ty < 0.0) {
        break;
      }
      piece = next;
    }
    const double px = piece->ty, py = -piece->tx;
    double dx = r.x[l] - piece->x, dy = r.y[l] - piece->y;
    if (piece->curvature == 0.0) {
      route.across.x[l] = px;
      route.across.y[l] = py;
      route.off[l] = dx * px + dy * py - env.route_shift;
      continue;
    }
    const double radius = 1.0 / piece->curvature;  // the centre is to port of the start
    dx -= radius * px;
    dy -= radius * py;
    const double side = radius > 0.0 ? 1.0 : -1.0;
    const double from_centre = __builtin_sqrt(dx * dx + dy * dy) + 1e-30;
    route.across.x[l] = -side * dx / from_centre;
    route.across.y[l] = -side * dy / from_centre;
    route.off[l] = radius - side * from_centre - env.route_shift;
    route.curvature[l] = side / from_centre;
  }
  return route;
}

inline NearestRoutePoint nearest_route_point(const LineEnvironment& env, const Vec& r) {
  if (env.route_pieces > 0) {
    return nearest_on_curved_route(env, r);
  }
  const Vec across{all(env.route_normal[0]), all(env.route_normal[1]), all(env.route_normal[2])};
  return {across, dot(across, r) - env.route_offset, Lanes{}};
}

/// Horizontal unit vector across the route, to port, at the point of the route nearest to r.
inline Vec across_route(const LineEnvironment& env, const Vec& r) {
  return nearest_route_point(env, r).across;
}

/// Unit vector on a plane seabed along the route, away from the vessel; for bathymetry see along_shape().
inline Vec along_route(const LineEnvironment& env, const Vec& r) {
  if (env.route_pieces == 0) {
    return {all(env.bed_along[0]), all(env.bed_along[1]), all(env.bed_along[2])};
  }
  const Vec across = across_route(env, r);
  const Vec n{all(env.bed_normal[0]), all(env.bed_normal[1]), all(env.bed_normal[2])};
  const Vec level{-1.0 * across.y, across.x, Lanes{}};
  const Vec along = level - dot(level, n) * n;
  return (1.0 / root(dot(along, along))) * along;
}

/// Direction along the route in the tangent plane of the bathymetry, with its derivative.
struct AlongShape {
  Vec direction;
  LevelColumns turn;
};

inline AlongShape along_shape(const LineEnvironment& env, const Vec& r, const SeabedUnder& bed) {
  const Vec across = across_route(env, r);
  const Vec ahead{-across.y, across.x, Lanes{}};
  const Lanes into = dot(ahead, bed.normal);
  const Vec flat = ahead - into * bed.normal;
  const Lanes inv = 1.0 / root(dot(flat, flat));
  const Vec along = inv * flat;
  const auto column = [&](const Vec& turn) {
    const Vec d = -1.0 * (dot(ahead, turn) * bed.normal + into * turn);
    return inv * (d - dot(along, d) * along);
  };
  return {along, {column(bed.turn.in_x), column(bed.turn.in_y)}};
}

}  // namespace
}  // namespace overbend::OVERBEND_ISA_NAMESPACE
