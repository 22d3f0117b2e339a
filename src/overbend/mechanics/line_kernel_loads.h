/// Weight, buoyancy, seabed and current at the Gauss points of a batch, with their exact derivatives. For
/// line_kernel.cpp alone.
#pragma once

#include "mechanics/line_kernel_batch.h"
#include "mechanics/line_kernel_ground.h"

namespace overbend::OVERBEND_ISA_NAMESPACE {
namespace {

struct Wetting {
  Lanes share, slope;
};

inline Wetting wetting(const Lanes& z, const Lanes& radius) {
  const Lanes c = z / radius;
  Wetting wet{c < 0.0 ? all(1.0) : Lanes{}, Lanes{}};
  if (!any(1.0 - c * c)) {  // almost every point is wholly under or wholly above the water
    return wet;
  }
  for (int l = 0; l < kWidth; ++l) {
    if (c[l] > -1.0 && c[l] < 1.0) {
      const double half_chord = __builtin_sqrt(1.0 - c[l] * c[l]);
      wet.share[l] = (__builtin_acos(c[l]) - c[l] * half_chord) / kPi;
      wet.slope[l] = -2.0 * half_chord / (kPi * radius[l]);
    }
  }
  return wet;
}

struct Current {
  Vec velocity, slope;  ///< Slope: derivative in z.
};

/// Linear between the rows of the table, constant beyond: the first row and what every interval adds.
inline Current current_at(const LineEnvironment& env, const Lanes& z) {
  Current now{{all(env.current_vx[0]), all(env.current_vy[0]), Lanes{}}, {}};
  for (int i = 0; i + 1 < env.current_rows; ++i) {
    const double below = env.current_z[i], above = env.current_z[i + 1], by_dz = 1.0 / (above - below);
    const double slope_x = (env.current_vx[i + 1] - env.current_vx[i]) * by_dz;
    const double slope_y = (env.current_vy[i + 1] - env.current_vy[i]) * by_dz;
    const Lanes from_below = z > below ? z - below : Lanes{};
    const Lanes part = z < above ? from_below : all(above - below);
    const Lanes inside = z < above ? (z > below ? all(1.0) : Lanes{}) : Lanes{};
    now.velocity.x += slope_x * part;
    now.velocity.y += slope_y * part;
    now.slope.x += slope_x * inside;
    now.slope.y += slope_y * inside;
  }
  now.velocity = env.current_scale * now.velocity;
  now.slope = env.current_scale * now.slope;
  return now;
}

/// Force per length at a point and its derivatives in position and tangent.
struct PointLoad {
  Vec f;
  Mat in_r, in_a;
};

inline void add_outer(Mat& m, const Lanes& s, const Vec& a, const Vec& b) {
  const Lanes ac[3] = {a.x, a.y, a.z}, bc[3] = {b.x, b.y, b.z};
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) {
      m.m[r][c] += s * ac[r] * bc[c];
    }
  }
}

/// Axial friction on a shape: what lies on the bed does not slide down its local slope, up to mu times the normal
/// force.
inline void add_downhill_friction(PointLoad& load, const LineEnvironment& env, const Vec& r, const BedUnder& bed,
                                  const Lanes& touching, const Lanes& normal, const Lanes& stiffness,
                                  const Lanes& submerged_weight) {
  const AlongShape along = along_shape(env, r, bed);
  const Lanes pull = touching * submerged_weight * along.direction.z;
  const Lanes limit = env.bed_friction_axial * normal;
  const Lanes sign = pull > 0.0 ? all(1.0) : all(-1.0);
  const Lanes sliding = sign * pull > limit ? all(1.0) : Lanes{};
  const Lanes size = sliding * sign * limit + (1.0 - sliding) * pull;
  load.f = load.f + size * along.direction;
  add_columns(load.in_r, size, along.turn);
  add_outer(load.in_r, -sliding * sign * env.bed_friction_axial * stiffness, along.direction, bed.gradient);
  const Vec rise{along.turn.in_x.z, along.turn.in_y.z, Lanes{}};
  add_outer(load.in_r, (1.0 - sliding) * touching * submerged_weight, along.direction, rise);
}

/// Axial friction on a route that bends keeps the laid pipe from sliding downhill as on a straight one, along the
/// direction of the place.
inline void add_downhill_friction_in_bend(PointLoad& load, const LineEnvironment& env, const Vec& r, const Vec& n,
                                          const Lanes& touching, const Lanes& normal, const Lanes& stiffness,
                                          const Lanes& submerged_weight) {
  const auto [across, off, curvature] = beside_route(env, r);
  const Vec level{-1.0 * across.y, across.x, Lanes{}};
  const Vec along = along_route(env, r);
  const Lanes pull = submerged_weight * along.z;
  const Lanes size = pull > 0.0 ? pull : -pull;
  const Lanes uphill = pull > 0.0 ? all(1.0) : all(-1.0);
  const Lanes limit = env.bed_friction_axial * normal;
  const Lanes sliding = size > limit ? all(1.0) : Lanes{};
  const Lanes force = uphill * (sliding * limit + (touching - sliding * touching) * size);
  load.f = load.f + force * along;
  add_outer(load.in_r, -env.bed_friction_axial * uphill * sliding * stiffness, along, n);
  // going along the bend turns the level direction towards its centre, and `along` as far as it lies on the bed
  const Vec turned = across - dot(across, n) * n;
  const Lanes rise = dot(level, n);
  const Vec turn = (curvature / root(1.0 - rise * rise)) * (turned - dot(along, turned) * along);
  add_outer(load.in_r, force, turn, level);
  add_outer(load.in_r, (touching - sliding * touching) * submerged_weight * turn.z, along, level);
}

/// Normal penalty on the pipe's underside and lateral friction against the lay route: elastic stick up to mu times the
/// normal force (statics: the pipe was laid on its route and has been pushed off it once).
inline void add_seabed(PointLoad& load, const LineEnvironment& env, const Vec& r, const Lanes& radius,
                       const Lanes& submerged_weight) {
  const BedUnder bed = bed_under(env, r, radius);
  const Vec& n = bed.normal;
  const Lanes penetration = radius - bed.clearance;
  if (!any(penetration)) {
    return;
  }
  const Lanes touching = penetration > 0.0 ? all(1.0) : Lanes{};
  Lanes stiffness = env.bed_stiffness * touching;
  Lanes normal = stiffness * penetration;
  if (env.bed_soil != 0) {
    const SoilForce soil = soil_force(env, touching, penetration);
    stiffness = soil.slope;
    normal = soil.force;
  }
  load.f = load.f + normal * n;
  add_outer(load.in_r, -stiffness, n, bed.gradient);
  if (env.bed_shape != nullptr) {
    add_columns(load.in_r, normal, bed.turn);
    if (env.bed_friction_axial > 0.0) {
      add_downhill_friction(load, env, r, bed, touching, normal, stiffness, submerged_weight);
    }
  } else if (env.bed_friction_axial > 0.0 && env.route_pieces > 0) {
    add_downhill_friction_in_bend(load, env, r, n, touching, normal, stiffness, submerged_weight);
  } else if (env.bed_friction_axial > 0.0 &&
             env.bed_along[2] != 0.0) {  // axial friction keeps the laid pipe from sliding downhill
    const Vec along = along_route(env, r);
    const double uphill = env.bed_along[2] > 0.0 ? 1.0 : -1.0;
    const Lanes pull = submerged_weight * (uphill * env.bed_along[2]);
    const Lanes limit = env.bed_friction_axial * normal;
    const Lanes sliding = pull > limit ? all(1.0) : Lanes{};
    load.f = load.f + (uphill * (sliding * limit + (touching - sliding * touching) * pull)) * along;
    add_outer(load.in_r, -uphill * env.bed_friction_axial * sliding * stiffness, along, n);
  }
  if (env.bed_friction_lateral > 0.0) {
    const auto [across, off, curvature] = beside_route(env, r);
    const Lanes stick = -env.bed_stick * touching * off;
    const Lanes limit = env.bed_friction_lateral * normal;
    const Lanes sign = off > 0.0 ? all(-1.0) : all(1.0);
    const Lanes size = stick > 0.0 ? stick : -stick;
    const Lanes sliding = size > limit ? all(1.0) : Lanes{};
    const Lanes force = sliding * sign * limit + (1.0 - sliding) * stick;
    load.f = load.f + force * across;
    if (env.route_pieces >
        0) {  // going along a bent route turns the direction across it: d across = -curvature d along
      const Vec level{-1.0 * across.y, across.x, Lanes{}};
      add_outer(load.in_r, -1.0 * curvature * force, level, level);
    }
    add_outer(load.in_r, -(1.0 - sliding) * env.bed_stick * touching, across, across);
    add_outer(load.in_r, -sliding * sign * env.bed_friction_lateral * stiffness, across, bed.gradient);
  }
}

/// Drag of a steady current, normal and tangential parts (Morison; DNV-RP-C205), times the wetted fraction.
inline void add_drag(PointLoad& load, const LineEnvironment& env, const Lanes& z, const Vec& a, const Wetting& wet,
                     const Lanes& drag_normal, const Lanes& drag_axial) {
  if (!any(wet.share)) {
    return;
  }
  const Current now = current_at(env, z);
  const Lanes inv_norm = 1.0 / root(dot(a, a));
  const Vec t = inv_norm * a;
  const Lanes ut = dot(now.velocity, t);
  const Vec un = now.velocity - ut * t;
  const Lanes size = root(dot(un, un)) + 1e-30;  // a pipe along the current has no normal drag, not 0/0
  const Lanes along = ut > 0.0 ? ut : -ut;
  const Vec fn = (drag_normal * size) * un;
  const Vec ft = (drag_axial * along * ut) * t;
  load.f = load.f + wet.share * (fn + ft);

  // d fn / d un = Cn (|un| I + un un'/|un|), d ft / d ut = 2 Ct |ut| t, d ft / d t = Ct |ut| ut I
  const Vec e = (1.0 / size) * un;
  const auto jacobian_n = [&](const Vec& v) { return drag_normal * (size * v + (size * dot(e, v)) * e); };
  const Vec slope_n = now.slope - dot(now.slope, t) * t;
  const Vec in_z = jacobian_n(slope_n) + (2.0 * drag_axial * along * dot(now.slope, t)) * t;
  const Vec z_column = wet.share * in_z + wet.slope * (fn + ft);
  load.in_r.m[0][2] += z_column.x;
  load.in_r.m[1][2] += z_column.y;
  load.in_r.m[2][2] += z_column.z;
  const Vec axes[3] = {{all(1.0), Lanes{}, Lanes{}}, {Lanes{}, all(1.0), Lanes{}}, {Lanes{}, Lanes{}, all(1.0)}};
  const Lanes scale = wet.share * inv_norm;
  for (int c = 0; c < 3; ++c) {
    const Vec dt = axes[c] - dot(axes[c], t) * t;  // times inv_norm: change of t with a_c
    const Lanes dut = dot(now.velocity, dt);
    const Vec dun = (-1.0 * dut) * t - ut * dt;
    const Vec df = jacobian_n(dun) + (2.0 * drag_axial * along * dut) * t + (drag_axial * along * ut) * dt;
    load.in_a.m[0][c] += scale * df.x;
    load.in_a.m[1][c] += scale * df.y;
    load.in_a.m[2][c] += scale * df.z;
  }
}

struct LoadConstants {
  Lanes weight, buoyancy, radius, drag_normal, drag_axial;
};

/// Adds a load at Gauss point i; external forces enter the residual with a minus sign.
template <bool kTangent>
inline void add_point_load(Batch& e, int i, const PointLoad& load) {
  const Shape& s = kGaussShape[i];
  const Lanes w = kGaussWeight[i] * e.h;
  for (int j = 0; j < 4; ++j) {
    add_force(e, j, -s.n[j], w * load.f);
  }
  if constexpr (kTangent) {
    for (int r3 = 0; r3 < 3; ++r3) {
      for (int c3 = 0; c3 < 3; ++c3) {
        const Lanes in_r = w * load.in_r.m[r3][c3];
        const Lanes in_a = w * e.inv_h * load.in_a.m[r3][c3];
        for (int k = 0; k < 4; ++k) {
          const Lanes x = s.n[k] * in_r + s.c[k] * in_a;
          for (int j = 0; j < 4; ++j) {
            e.k[3 * j + r3][3 * k + c3] -= s.n[j] * x;
          }
        }
      }
    }
  }
}

/// Weight, buoyancy, seabed and current by Gauss points; external forces enter the residual with a minus sign.
template <bool kTangent>
inline void add_loads(Batch& e, const LineEnvironment& env, const LoadConstants& c) {
  for (int i = 0; i < kGaussPoints; ++i) {
    const Shape& s = kGaussShape[i];
    const Vec r = combine(e, s.n);
    const Vec a = e.inv_h * combine_derivative(e, s.c);
    const Wetting wet = wetting(r.z, c.radius);
    PointLoad load{};
    load.f.z = c.buoyancy * wet.share - c.weight;
    load.in_r.m[2][2] = c.buoyancy * wet.slope;
    add_seabed(load, env, r, c.radius, c.weight - c.buoyancy);
    if (env.current_rows > 0) {
      add_drag(load, env, r.z, a, wet, c.drag_normal, c.drag_axial);
    }
    add_point_load<kTangent>(e, i, load);
  }
}

}  // namespace
}  // namespace overbend::OVERBEND_ISA_NAMESPACE
