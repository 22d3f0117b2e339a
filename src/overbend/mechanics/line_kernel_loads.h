/// Weight, buoyancy, seabed and current at the Gauss points of a batch, with their exact derivatives. For
/// line_kernel.cpp only.
#pragma once

#include "mechanics/line_kernel_energy.h"
#include "mechanics/line_kernel_ground.h"

namespace overbend::OVERBEND_ISA_NAMESPACE {
namespace {

struct Wetting {
  Lanes share, slope;
};

/// Wetting of points near the surface. Lane-by-lane code is kept out of line: inlined, it would spill its operands from
/// registers.
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
  if (!any(radius * radius - z * z)) {  // most points are fully above or below the surface
    return {z < 0.0 ? all(1.0) : Lanes{}, Lanes{}};
  }
  return wetting_at_surface(z, radius);
}

struct Current {
  Vec velocity, slope;  ///< Derivative in z.
};

/// Returns the current, linear between the rows of the table and constant beyond: starts from a row below all points
/// and adds the intervals above it up to the highest point.
inline Current current_at(const LineEnvironment& env, const Lanes& z) {
  int i = 0;
  while (i + 2 < env.current_rows && !any(env.current_z[i + 1] - z)) ++i;
  Current current{{all(env.current_vx[i]), all(env.current_vy[i]), Lanes{}}, {}};
  for (; i + 1 < env.current_rows && any(z - env.current_z[i]); ++i) {
    const double below = env.current_z[i], above = env.current_z[i + 1], by_dz = 1.0 / (above - below);
    const double slope_x = (env.current_vx[i + 1] - env.current_vx[i]) * by_dz;
    const double slope_y = (env.current_vy[i + 1] - env.current_vy[i]) * by_dz;
    const Lanes from_below = z > below ? z - below : Lanes{};
    const Lanes part = z < above ? from_below : all(above - below);
    const Lanes inside = z < above ? (z > below ? all(1.0) : Lanes{}) : Lanes{};
    current.velocity.x += slope_x * part;
    current.velocity.y += slope_y * part;
    current.slope.x += slope_x * inside;
    current.slope.y += slope_y * inside;
  }
  current.velocity = env.current_scale * current.velocity;
  current.slope = env.current_scale * current.slope;
  return current;
}

/// Force per length at a point and, with a tangent, its derivatives with position and tangent vector.
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

/// Adds to the derivative of a load with position: s a b'.
template <bool kTangent>
inline void add_in_place(PointLoad<kTangent>& load, const Lanes& s, const Vec& a, const Vec& b) {
  if constexpr (kTangent) {
    add_outer(load.in_r, s, a, b);
  }
}

/// Adds to the derivative of a load with position: s times a derivative with x and y.
template <bool kTangent>
inline void add_in_place(PointLoad<kTangent>& load, const Lanes& s, const LevelColumns& columns) {
  if constexpr (kTangent) {
    add_columns(load.in_r, s, columns);
  }
}

/// Returns a load that depends on height only, with slope `in_z`.
template <bool kTangent>
inline PointLoad<kTangent> make_height_load(const Vec& f, const Lanes& in_z) {
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

/// Axial friction on bathymetry: prevents sliding down the local slope, up to mu times the normal force.
template <bool kTangent>
inline void add_downhill_friction(PointLoad<kTangent>& load, const LineEnvironment& env, const Vec& r,
                                  const SeabedUnder& bed, const Lanes& touching, const Lanes& normal,
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

/// Axial friction on a curved route: prevents sliding downhill as on a straight one, along the local direction.
template <bool kTangent>
inline void add_downhill_friction_in_bend(PointLoad<kTangent>& load, const LineEnvironment& env, const Vec& r,
                                          const Vec& n, const Lanes& touching, const Lanes& normal,
                                          const Lanes& stiffness, const Lanes& submerged_weight) {
  const auto [across, off, curvature] = nearest_route_point(env, r);
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
  // along the bend the level direction turns towards the centre, and so does `along` within the seabed
  const Vec turned = across - dot(across, n) * n;
  const Lanes rise = dot(level, n);
  const Vec turn = (curvature / root(1.0 - rise * rise)) * (turned - dot(along, turned) * along);
  add_in_place(load, force, turn, level);
  add_in_place(load, (touching - sliding * touching) * submerged_weight * turn.z, along, level);
}

/// Friction of a line dragged along the seabed: `drag` times the normal force, along the route in the plane of the
/// seabed.
template <bool kTangent>
inline void add_dragging_friction(PointLoad<kTangent>& load, const LineEnvironment& env, const Vec& r,
                                  const SeabedUnder& bed, const Lanes& normal, const Lanes& stiffness,
                                  const Lanes& drag) {
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

/// Axial friction that prevents the laid pipe from sliding down a plane seabed.
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

/// Normal penalty on the underside of the pipe and lateral friction relative to the lay route: elastic stick up to mu
/// times the normal force (statics: the pipe was laid on its route and displaced from it once).
template <bool kTangent>
inline void add_seabed(PointLoad<kTangent>& load, const LineEnvironment& env, const Vec& r, const Lanes& radius,
                       const Lanes& submerged_weight, const Lanes& drag) {
  if (!near_bed(env, r, radius)) {
    return;
  }
  const SeabedUnder bed = bed_under(env, r, radius);
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
    const auto [across, off, curvature] = nearest_route_point(env, r);
    const Lanes stick = -env.bed_stick * touching * off;
    const Lanes limit = env.bed_friction_lateral * normal;
    const Lanes sign = off > 0.0 ? all(-1.0) : all(1.0);
    const Lanes size = stick > 0.0 ? stick : -stick;
    const Lanes sliding = size > limit ? all(1.0) : Lanes{};
    const Lanes force = sliding * sign * limit + (1.0 - sliding) * stick;
    load.f = load.f + force * across;
    if (env.route_pieces > 0) {  // along a curved route the transverse direction turns: d across = -curvature d along
      const Vec level{-1.0 * across.y, across.x, Lanes{}};
      add_in_place(load, -1.0 * curvature * force, level, level);
    }
    add_in_place(load, -(1.0 - sliding) * env.bed_stick * touching, across, across);
    add_in_place(load, -sliding * sign * env.bed_friction_lateral * stiffness, across, bed.gradient);
  }
}

/// Adds df/dt' (I - t t') / |a| to the derivative with the tangent, for df/dt' = t w' + s I + d e e', e normal to t.
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
  Vec t;           ///< Unit vector along the pipe.
  Lanes ut;        ///< Component of u along the pipe.
  Vec un;          ///< Component of u across the pipe.
  Lanes by_size;   ///< Cn |un|
  Lanes by_along;  ///< Ct |ut|
  Lanes inv_size;  ///< 1 / |un|
};

template <bool kTangent>
inline Drag compute_drag(const Vec& t, const Vec& u, const Lanes& normal, const Lanes& axial) {
  Drag d;
  d.t = t;
  d.ut = dot(u, t);
  d.un = u - d.ut * t;
  const Lanes size = root(dot(d.un, d.un)) + 1e-30;  // avoids 0/0 where water flows along the pipe
  d.by_size = normal * size;
  d.by_along = axial * (d.ut > 0.0 ? d.ut : -d.ut);
  if constexpr (kTangent) {
    d.inv_size = 1.0 / size;
  }
  return d;
}

/// Change of the drag with the velocity of the water: Cn (|un| I + un un'/|un|) across, 2 Ct |ut| along.
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
  const Current current = current_at(env, z);
  const Drag d = compute_drag<kTangent>(slope.inv_norm * slope.a, current.velocity, drag_normal, drag_axial);
  const Vec f = d.by_size * d.un + (d.by_along * d.ut) * d.t;
  load.f = load.f + wet.share * f;
  if constexpr (kTangent) {
    const Vec z_column = wet.share * with_velocity(d, current.slope) + wet.slope * f;
    load.in_r.m[0][2] += z_column.x;
    load.in_r.m[1][2] += z_column.y;
    load.in_r.m[2][2] += z_column.z;
    // Rotation of the pipe: d un = -(u.dt) t - ut dt; in terms of the drag t (2 Ct |ut| - Cn |un|) u' and the rest.
    add_turning(load.in_a, wet.share * slope.inv_norm, d.t, (2.0 * d.by_along - d.by_size) * current.velocity,
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
inline PointLoad<kTangent> static_load(const LineEnvironment& env, const LoadConstants& c, const Vec& r,
                                       const PointSlope& slope) {
  const Wetting wet = wetting(r.z, c.radius);
  PointLoad<kTangent> load =
      make_height_load<kTangent>({Lanes{}, Lanes{}, c.buoyancy * wet.share - c.weight}, c.buoyancy * wet.slope);
  add_seabed(load, env, r, c.radius, c.weight - c.buoyancy, c.drag_on_bed);
  if (env.current_rows > 0) {
    add_drag(load, env, r.z, slope, wet, c.drag_normal, c.drag_axial);
  }
  return load;
}

}  // namespace
}  // namespace overbend::OVERBEND_ISA_NAMESPACE
