/// Weight, buoyancy, seabed and current at the Gauss points of a batch, with their exact derivatives. For
/// line_kernel.cpp alone.
#pragma once

#include "mechanics/line_kernel_energy.h"
#include "mechanics/line_kernel_ground.h"

namespace overbend::OVERBEND_ISA_NAMESPACE {
namespace {

struct Wetting {
  Lanes share, slope;
};

/// Of points some of which the surface cuts. What looks at lanes one by one has a call of its own: it would keep all
/// that it touches out of registers.
inline __attribute__((noinline)) Wetting wetting_at_surface(const Lanes& z, const Lanes& radius) {
  Wetting wet{z < 0.0 ? all(1.0) : Lanes{}, Lanes{}};
  const Lanes c = z / radius;
  for (int l = 0; l < kWidth; ++l) {
    if (c[l] > -1.0 && c[l] < 1.0) {
      const double half_chord = __builtin_sqrt(1.0 - c[l] * c[l]);
      wet.share[l] = (__builtin_acos(c[l]) - c[l] * half_chord) / kPi;
      wet.slope[l] = -2.0 * half_chord / (kPi * radius[l]);
    }
  }
  return wet;
}

inline Wetting wetting(const Lanes& z, const Lanes& radius) {
  if (!any(radius * radius - z * z)) {  // almost every point is wholly under or wholly above the water
    return {z < 0.0 ? all(1.0) : Lanes{}, Lanes{}};
  }
  return wetting_at_surface(z, radius);
}

struct Current {
  Vec velocity, slope;  ///< Slope: derivative in z.
};

/// Linear between the rows of the table, constant beyond: a row below all points and what the intervals over it add, as
/// far as they reach any.
inline Current current_at(const LineEnvironment& env, const Lanes& z) {
  int i = 0;
  while (i + 2 < env.current_rows && !any(env.current_z[i + 1] - z)) ++i;
  Current now{{all(env.current_vx[i]), all(env.current_vy[i]), Lanes{}}, {}};
  for (; i + 1 < env.current_rows && any(z - env.current_z[i]); ++i) {
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

/// Force per length at a point and, where a tangent is asked for, its derivatives in position and tangent.
template <bool kTangent>
struct PointLoad {
  Vec f;
};
template <>
struct PointLoad<true> {
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

/// Derivative of a load in the position: s a b'.
template <bool kTangent>
inline void add_in_place(PointLoad<kTangent>& load, const Lanes& s, const Vec& a, const Vec& b) {
  if constexpr (kTangent) {
    add_outer(load.in_r, s, a, b);
  }
}

/// The same: s times a derivative in x and y.
template <bool kTangent>
inline void add_in_place(PointLoad<kTangent>& load, const Lanes& s, const LevelColumns& columns) {
  if constexpr (kTangent) {
    add_columns(load.in_r, s, columns);
  }
}

/// A load that depends on nothing but, with slope `in_z`, on the height.
template <bool kTangent>
inline PointLoad<kTangent> load_of(const Vec& f, const Lanes& in_z) {
  PointLoad<kTangent> load;
  load.f = f;
  if constexpr (kTangent) {
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) {
        load.in_r.m[r][c] = load.in_a.m[r][c] = Lanes{};
      }
    }
    load.in_r.m[2][2] = in_z;
  }
  return load;
}

/// Axial friction on a shape: what lies on the bed does not slide down its local slope, up to mu times the normal
/// force.
template <bool kTangent>
inline void add_downhill_friction(PointLoad<kTangent>& load, const LineEnvironment& env, const Vec& r,
                                  const BedUnder& bed, const Lanes& touching, const Lanes& normal,
                                  const Lanes& stiffness, const Lanes& submerged_weight) {
  const AlongShape along = along_shape(env, r, bed);
  const Lanes pull = touching * submerged_weight * along.direction.z;
  const Lanes limit = env.bed_friction_axial * normal;
  const Lanes sign = pull > 0.0 ? all(1.0) : all(-1.0);
  const Lanes sliding = sign * pull > limit ? all(1.0) : Lanes{};
  const Lanes size = sliding * sign * limit + (1.0 - sliding) * pull;
  load.f = load.f + size * along.direction;
  add_in_place(load, size, along.turn);
  add_in_place(load, -sliding * sign * env.bed_friction_axial * stiffness, along.direction, bed.gradient);
  const Vec rise{along.turn.in_x.z, along.turn.in_y.z, Lanes{}};
  add_in_place(load, (1.0 - sliding) * touching * submerged_weight, along.direction, rise);
}

/// Axial friction on a route that bends keeps the laid pipe from sliding downhill as on a straight one, along the
/// direction of the place.
template <bool kTangent>
inline void add_downhill_friction_in_bend(PointLoad<kTangent>& load, const LineEnvironment& env, const Vec& r,
                                          const Vec& n, const Lanes& touching, const Lanes& normal,
                                          const Lanes& stiffness, const Lanes& submerged_weight) {
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
  add_in_place(load, -env.bed_friction_axial * uphill * sliding * stiffness, along, n);
  // going along the bend turns the level direction towards its centre, and `along` as far as it lies on the bed
  const Vec turned = across - dot(across, n) * n;
  const Lanes rise = dot(level, n);
  const Vec turn = (curvature / root(1.0 - rise * rise)) * (turned - dot(along, turned) * along);
  add_in_place(load, force, turn, level);
  add_in_place(load, (touching - sliding * touching) * submerged_weight * turn.z, along, level);
}

/// Friction of a line dragged along the bed: `drag` times the normal force, along the route as it lies on the bed.
template <bool kTangent>
inline void add_dragging_friction(PointLoad<kTangent>& load, const LineEnvironment& env, const Vec& r,
                                  const BedUnder& bed, const Lanes& normal, const Lanes& stiffness, const Lanes& drag) {
  const Lanes force = drag * normal;
  if (env.bed_shape == nullptr) {
    const Vec along = along_route(env, r);
    load.f = load.f + force * along;
    add_in_place(load, -drag * stiffness, along, bed.gradient);
    return;
  }
  const AlongShape along = along_shape(env, r, bed);
  load.f = load.f + force * along.direction;
  add_in_place(load, force, along.turn);
  add_in_place(load, -drag * stiffness, along.direction, bed.gradient);
}

/// Axial friction that keeps the laid pipe from sliding down a plane bed.
template <bool kTangent>
inline void add_downhill_friction_on_plane(PointLoad<kTangent>& load, const LineEnvironment& env, const Vec& r,
                                           const Vec& n, const Lanes& touching, const Lanes& normal,
                                           const Lanes& stiffness, const Lanes& submerged_weight) {
  const Vec along = along_route(env, r);
  const double uphill = env.bed_along[2] > 0.0 ? 1.0 : -1.0;
  const Lanes pull = submerged_weight * (uphill * env.bed_along[2]);
  const Lanes limit = env.bed_friction_axial * normal;
  const Lanes sliding = pull > limit ? all(1.0) : Lanes{};
  load.f = load.f + (uphill * (sliding * limit + (touching - sliding * touching) * pull)) * along;
  add_in_place(load, -uphill * env.bed_friction_axial * sliding * stiffness, along, n);
}

/// Normal penalty on the pipe's underside and lateral friction against the lay route: elastic stick up to mu times the
/// normal force (statics: the pipe was laid on its route and has been pushed off it once).
template <bool kTangent>
inline void add_seabed(PointLoad<kTangent>& load, const LineEnvironment& env, const Vec& r, const Lanes& radius,
                       const Lanes& submerged_weight, const Lanes& drag) {
  if (!near_bed(env, r, radius)) {
    return;
  }
  const BedUnder bed = bed_under(env, r, radius);
  const Vec& n = bed.normal;
  const Lanes penetration = radius - bed.clearance;
  const Lanes touching = penetration > 0.0 ? all(1.0) : Lanes{};
  Lanes stiffness = env.bed_stiffness * touching;
  Lanes normal = stiffness * penetration;
  if (env.bed_soil != 0) {
    const SoilForce soil = soil_force(env, touching, penetration);
    stiffness = soil.slope;
    normal = soil.force;
  }
  load.f = load.f + normal * n;
  add_in_place(load, -stiffness, n, bed.gradient);
  if (env.bed_shape != nullptr) {
    add_in_place(load, normal, bed.turn);
  }
  if (env.dragged) {
    add_dragging_friction(load, env, r, bed, normal, stiffness, drag);
  } else if (env.bed_shape != nullptr) {
    if (env.bed_friction_axial > 0.0) {
      add_downhill_friction(load, env, r, bed, touching, normal, stiffness, submerged_weight);
    }
  } else if (env.bed_friction_axial > 0.0 && env.route_pieces > 0) {
    add_downhill_friction_in_bend(load, env, r, n, touching, normal, stiffness, submerged_weight);
  } else if (env.bed_friction_axial > 0.0 && env.bed_along[2] != 0.0) {
    add_downhill_friction_on_plane(load, env, r, n, touching, normal, stiffness, submerged_weight);
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
      add_in_place(load, -1.0 * curvature * force, level, level);
    }
    add_in_place(load, -(1.0 - sliding) * env.bed_stick * touching, across, across);
    add_in_place(load, -sliding * sign * env.bed_friction_lateral * stiffness, across, bed.gradient);
  }
}

/// Adds df/dt' (I - t t') / |a| to the derivative in the tangent, for df/dt' = t w' + s I + d e e', e normal to t.
inline void add_turning(Mat& in_a, const Lanes& scale, const Vec& t, const Vec& w, const Lanes& s, const Lanes& d,
                        const Vec& e) {
  const Vec across = scale * (w - (dot(w, t) + s) * t);
  const Mat m = full(dyad(scale * s, scale * d, e));
  const Lanes tc[3] = {t.x, t.y, t.z}, wc[3] = {across.x, across.y, across.z};
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) {
      in_a.m[r][c] += m.m[r][c] + tc[r] * wc[c];
    }
  }
}

/// Quadratic drag on the relative velocity u of the water.
struct Drag {
  Vec t;           ///< Along the pipe.
  Lanes ut;        ///< u along it.
  Vec un;          ///< u across it.
  Lanes by_size;   ///< Cn |un|
  Lanes by_along;  ///< Ct |ut|
  Lanes inv_size;  ///< 1 / |un|
};

template <bool kTangent>
inline Drag drag_of(const Vec& t, const Vec& u, const Lanes& normal, const Lanes& axial) {
  Drag d;
  d.t = t;
  d.ut = dot(u, t);
  d.un = u - d.ut * t;
  const Lanes size = root(dot(d.un, d.un)) + 1e-30;  // water along the pipe has no normal drag, not 0/0
  d.by_size = normal * size;
  d.by_along = axial * (d.ut > 0.0 ? d.ut : -d.ut);
  if constexpr (kTangent) {
    d.inv_size = 1.0 / size;
  }
  return d;
}

/// What a change of the water's velocity changes: Cn (|un| I + un un'/|un|) across, 2 Ct |ut| along.
inline Vec with_velocity(const Drag& d, const Vec& change) {
  const Vec across = change - dot(change, d.t) * d.t;
  return d.by_size * (across + (d.inv_size * d.inv_size * dot(d.un, across)) * d.un) +
         (2.0 * d.by_along * dot(change, d.t)) * d.t;
}

/// Drag of a steady current, normal and tangential parts (Morison; DNV-RP-C205), times the wetted fraction.
template <bool kTangent>
inline void add_drag(PointLoad<kTangent>& load, const LineEnvironment& env, const Lanes& z, const PointSlope& slope,
                     const Wetting& wet, const Lanes& drag_normal, const Lanes& drag_axial) {
  if (!any(wet.share)) {
    return;
  }
  const Current now = current_at(env, z);
  const Drag d = drag_of<kTangent>(slope.inv_norm * slope.a, now.velocity, drag_normal, drag_axial);
  const Vec f = d.by_size * d.un + (d.by_along * d.ut) * d.t;
  load.f = load.f + wet.share * f;
  if constexpr (kTangent) {
    const Vec z_column = wet.share * with_velocity(d, now.slope) + wet.slope * f;
    load.in_r.m[0][2] += z_column.x;
    load.in_r.m[1][2] += z_column.y;
    load.in_r.m[2][2] += z_column.z;
    // Turning the pipe: d un = -(u.dt) t - ut dt; in the drag's own terms t (2 Ct |ut| - Cn |un|) u' and the rest.
    add_turning(load.in_a, wet.share * slope.inv_norm, d.t, (2.0 * d.by_along - d.by_size) * now.velocity,
                d.ut * (d.by_along - d.by_size), -d.ut * d.by_size, d.inv_size * d.un);
  }
}

struct LoadConstants {
  Lanes weight, buoyancy, radius, drag_normal, drag_axial, drag_on_bed;
};

/// Adds a load at Gauss point i; external forces enter the residual with a minus sign. `tangent` is null unless
/// kTangent.
template <bool kTangent>
inline void add_load(Batch& e, BatchTangent* tangent, int i, const PointLoad<kTangent>& load) {
  const Lanes w = -kGauss[i].weight * e.h;
  add_force(e, kGauss[i], w * load.f);
  if constexpr (kTangent) {
    const Lanes w_a = w * e.inv_h;
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) {
        tangent->in_r[i].m[r][c] = w * load.in_r.m[r][c];
        tangent->in_a[i].m[r][c] = w_a * load.in_a.m[r][c];
      }
    }
  }
}

/// Weight, buoyancy, seabed and current at a Gauss point.
template <bool kTangent>
inline PointLoad<kTangent> resting_load(const LineEnvironment& env, const LoadConstants& c, const Vec& r,
                                        const PointSlope& slope) {
  const Wetting wet = wetting(r.z, c.radius);
  PointLoad<kTangent> load =
      load_of<kTangent>({Lanes{}, Lanes{}, c.buoyancy * wet.share - c.weight}, c.buoyancy * wet.slope);
  add_seabed(load, env, r, c.radius, c.weight - c.buoyancy, c.drag_on_bed);
  if (env.current_rows > 0) {
    add_drag(load, env, r.z, slope, wet, c.drag_normal, c.drag_axial);
  }
  return load;
}

}  // namespace
}  // namespace overbend::OVERBEND_ISA_NAMESPACE
