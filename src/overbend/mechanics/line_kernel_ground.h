/// Bed and route under a batch of points: the one place where the kernel computes them. For line_kernel.cpp alone.
///
/// A plane is the fast path. Where a bed has a shape, gap and normal are those of the tangent plane at the same x and
/// y: clearance = (z - z_bed) cos(slope), normal = (-dz_bed/dx, -dz_bed/dy, 1) cos(slope), so that the clearance grows
/// along its own gradient, which is not quite the normal, and the normal turns with the place.
#pragma once

#include "mechanics/line_kernel_batch.h"
#include "mechanics/soil_law.h"

namespace overbend {

/// Height of a shape under a place and its derivatives, see model/site/bed_shape.h.
void bed_values(const BedShape* shape, double x, double y, double* six);

}  // namespace overbend

namespace overbend::OVERBEND_ISA_NAMESPACE {
namespace {

/// Columns of a derivative in the place that has none in z.
struct LevelColumns {
  Vec in_x, in_y;
};

struct BedUnder {
  Vec normal;
  Lanes clearance;    ///< Of the axis from the bed, along its normal [m].
  Vec gradient;       ///< Of the clearance; of a plane its normal.
  LevelColumns turn;  ///< Derivative of the normal; only of a shape, as what follows from it.
};

/// One lane over a shape.
inline void put_shape_under(BedUnder& under, int l, const LineEnvironment& env, const Vec& r) {
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

/// Points that no place of a shape reaches, given the pipe's radius, get a clearance that says so.
inline __attribute__((noinline)) BedUnder shape_under(const LineEnvironment& env, const Vec& r, const Lanes& radius) {
  BedUnder under{{Lanes{}, Lanes{}, all(1.0)}, r.z - env.bed_highest, {Lanes{}, Lanes{}, all(1.0)}, LevelColumns{}};
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

inline BedUnder bed_under(const LineEnvironment& env, const Vec& r, const Lanes& radius) {
  if (env.bed_shape != nullptr) return shape_under(env, r, radius);
  const Vec n = plane_normal(env);
  return {n, dot(n, r) - env.bed_offset, n, LevelColumns{}};
}

/// Whether any point may lie on the bed: of most lines most do not, and they are spared the rest.
inline bool near_bed(const LineEnvironment& env, const Vec& r, const Lanes& radius) {
  return any(env.bed_shape != nullptr ? radius - (r.z - env.bed_highest)
                                      : radius - (dot(plane_normal(env), r) - env.bed_offset));
}

/// Force per length of soil that is not linear, its derivative in the penetration and its integral; see
/// mechanics/soil_law.h for the laws. All 0 where nothing touches.
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

/// m += s times a derivative in x and y.
inline void add_columns(Mat& m, const Lanes& s, const LevelColumns& columns) {
  m.m[0][0] += s * columns.in_x.x;
  m.m[1][0] += s * columns.in_x.y;
  m.m[2][0] += s * columns.in_x.z;
  m.m[0][1] += s * columns.in_y.x;
  m.m[1][1] += s * columns.in_y.y;
  m.m[2][1] += s * columns.in_y.z;
}

/// The columns' products with a vector.
inline Vec transposed_times(const LevelColumns& columns, const Vec& v) {
  return {dot(columns.in_x, v), dot(columns.in_y, v), Lanes{}};
}

/// The route where it is nearest to a point.
struct RouteBeside {
  Vec across;       ///< Horizontal unit vector, to port.
  Lanes off;        ///< Distance of the point, to port [m].
  Lanes curvature;  ///< Of the line beside the route through the point, positive where it turns to port [1/m].
};

/// Of a route with arcs: the piece is the last whose beginning the point has passed.
inline __attribute__((noinline)) RouteBeside beside_bent_route(const LineEnvironment& env, const Vec& r) {
  RouteBeside at{{Lanes{}, Lanes{}, Lanes{}}, Lanes{}, Lanes{}};
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
      at.across.x[l] = px;
      at.across.y[l] = py;
      at.off[l] = dx * px + dy * py - env.route_shift;
      continue;
    }
    const double radius = 1.0 / piece->curvature;  // to port of the beginning lies the centre
    dx -= radius * px;
    dy -= radius * py;
    const double side = radius > 0.0 ? 1.0 : -1.0;
    const double from_centre = __builtin_sqrt(dx * dx + dy * dy) + 1e-30;
    at.across.x[l] = -side * dx / from_centre;
    at.across.y[l] = -side * dy / from_centre;
    at.off[l] = radius - side * from_centre - env.route_shift;
    at.curvature[l] = side / from_centre;
  }
  return at;
}

inline RouteBeside beside_route(const LineEnvironment& env, const Vec& r) {
  if (env.route_pieces > 0) {
    return beside_bent_route(env, r);
  }
  const Vec across{all(env.route_normal[0]), all(env.route_normal[1]), all(env.route_normal[2])};
  return {across, dot(across, r) - env.route_offset, Lanes{}};
}

/// Horizontal unit vector across the route, to port, at the point of the route nearest to r.
inline Vec across_route(const LineEnvironment& env, const Vec& r) {
  return beside_route(env, r).across;
}

/// Unit vector on a plane bed along the route, away from the barge; on a shape see along_shape().
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

/// The same on a shape, with its derivative: the route's direction as it lies in the tangent plane.
struct AlongShape {
  Vec direction;
  LevelColumns turn;
};

inline AlongShape along_shape(const LineEnvironment& env, const Vec& r, const BedUnder& bed) {
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
