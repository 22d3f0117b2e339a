/// Inertia, Morison's forces and the bed's friction at the Gauss points of a batch in motion, with their exact
/// derivatives; energies. For line_kernel.cpp alone.
#pragma once

#include "mechanics/line_kernel_loads.h"

namespace overbend::OVERBEND_ISA_NAMESPACE {
namespace {

inline constexpr int kTangentNodes[2] = {1, 3};  ///< Which of r1, t1, r2, t2 are tangents.

/// Motion of a batch: like Batch::q, tangents scaled by the element length; water at both ends.
struct BatchMotion {
  Vec v[4], acc[4];
  Vec water_v[2], water_a[2];
  Lanes surface[2];
  Lanes head[2];
};

/// Water at both ends, linear along an element; beyond the last element, of the last.
inline void gather_water(BatchMotion& m, const double* water, int first, int count) {
  Lanes ends[2][kWaterValues] = {};
  if (first + kWidth <= count) {
    load_rows<kWaterValues>(ends[0], water + kWaterValues * first);
    for (int i = 0; i < kWaterValues; ++i) {
      ends[1][i] = from_next(ends[0][i], water[kWaterValues * (first + kWidth) + i]);
    }
  } else {
    for (int l = 0; l < kWidth; ++l) {
      const double* node = water + kWaterValues * (first + l < count ? first + l : count - 1);
      for (int i = 0; i < kWaterValues; ++i) {
        ends[0][i][l] = node[i];
        ends[1][i][l] = node[kWaterValues + i];
      }
    }
  }
  for (int end = 0; end < 2; ++end) {
    const Lanes(&w)[kWaterValues] = ends[end];
    m.water_v[end] = {w[0], w[1], w[2]};
    m.water_a[end] = {w[3], w[4], w[5]};
    m.surface[end] = w[6];
    m.head[end] = w[7];
  }
}

inline void gather_motion(BatchMotion& m, const Lanes& h, const LineMotion& motion, int first, int count) {
  gather_nodes(m.v, motion.v, first, count);
  gather_nodes(m.acc, motion.acc, first, count);
  for (const int tangent : kTangentNodes) {
    m.v[tangent] = h * m.v[tangent];
    m.acc[tangent] = h * m.acc[tangent];
  }
  if (motion.water != nullptr) {
    return gather_water(m, motion.water, first, count);
  }
  for (int end = 0; end < 2; ++end) {
    m.water_v[end] = m.water_a[end] = Vec{};
    m.surface[end] = m.head[end] = Lanes{};
  }
}

inline Vec combine_nodes(const Vec (&nodes)[4], const double (&s)[4]) {
  return s[0] * nodes[0] + s[1] * nodes[1] + s[2] * nodes[2] + s[3] * nodes[3];
}

/// Constants of a moving batch beside LoadConstants.
struct InertiaConstants {
  Lanes mass, displaced, added_normal, added_axial;
};

/// Place and motion at a Gauss point of a moving line, and the waves there.
struct MovingPoint {
  Vec r, v, acc;
  Vec water_v, water_a;
  Lanes surface;  ///< Elevation of the water [m].
};

inline MovingPoint moving_point(const Batch& e, const BatchMotion& m, const Shape& s, double xi) {
  MovingPoint at;
  at.r = combine(e, s.n);
  at.v = combine_nodes(m.v, s.n);
  at.acc = combine_nodes(m.acc, s.n);
  at.water_v = (1.0 - xi) * m.water_v[0] + xi * m.water_v[1];
  at.water_a = (1.0 - xi) * m.water_a[0] + xi * m.water_a[1];
  at.surface = mixed(m.surface, xi);
  return at;
}

inline void add_sym(Mat& m, const Lanes& scale, const Sym& s) {
  const Mat f = full(s);
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) {
      m.m[r][c] += scale * f.m[r][c];
    }
  }
}

/// Morison's force of moving water on the moving pipe: drag on the relative velocity and added mass on the relative
/// acceleration, each with its normal and tangential part, and the force rho A a_water of the pressure field that
/// accelerates the displaced water (Morison et al. 1950; DNV-RP-C205 section 6). The last acts in all directions: along
/// the pipe it is the gradient of the dynamic pressure that the effective tension contains. Times the wetted fraction.
template <bool kTangent>
inline void add_morison(PointLoad<kTangent>& load, const LineEnvironment& env, const LineMotion& motion,
                        const MovingPoint& at, const PointSlope& slope, const Wetting& wet, const LoadConstants& c,
                        const InertiaConstants& i) {
  if (!any(wet.share)) {
    return;
  }
  Vec u = at.water_v - at.v;
  Vec current_slope{};
  if (env.current_rows > 0) {
    const Current now = current_at(env, at.r.z);
    u = u + now.velocity;
    current_slope = now.slope;
  }
  const Drag d = drag_of<kTangent>(slope, u, c.drag_normal, c.drag_axial);
  const Vec slip = at.water_a - at.acc;
  const Lanes more_along = i.added_axial - i.added_normal;
  const Lanes slip_t = more_along * dot(slip, d.t);
  const Vec f =
      d.by_size * d.un + (d.by_along * d.ut + slip_t) * d.t + i.displaced * at.water_a + i.added_normal * slip;
  load.f = load.f + wet.share * f;
  if constexpr (kTangent) {
    const Vec z_column = wet.share * with_velocity(d, current_slope) + wet.slope * f;
    load.in_r.m[0][2] += z_column.x;
    load.in_r.m[1][2] += z_column.y;
    load.in_r.m[2][2] += z_column.z;
    // By the velocity: -[Cn |un| (I - t t' + e e') + 2 Ct |ut| t t']; by the acceleration: -[Ca (I - t t') + Ct_a t
    // t'].
    const Vec e = d.inv_size * d.un;
    const Lanes drag = motion.velocity_share * d.by_size;
    const Lanes drag_t = 2.0 * motion.velocity_share * d.by_along;
    const Lanes added = motion.acceleration_share * i.added_normal;
    const Lanes added_t = motion.acceleration_share * i.added_axial;
    add_sym(load.in_r, -wet.share, dyads(drag + added, drag_t + added_t - drag - added, d.t, drag, e, Lanes{}));
    add_turning(load.in_a, wet.share * d.inv_norm, d.t, (2.0 * d.by_along - d.by_size) * u + more_along * slip,
                d.ut * (d.by_along - d.by_size) + slip_t, -d.ut * d.by_size, e);
  }
}

/// One direction of the bed's friction: elastic stretch up to mu times the normal force, then sliding (return mapping).
/// Returns the new stretch.
template <bool kTangent>
inline Lanes add_bed_friction(PointLoad<kTangent>& load, const LineEnvironment& env, const LineMotion& motion,
                              const Vec& n, const Vec& direction, double mu, const Lanes& touching, const Lanes& normal,
                              const Lanes& normal_in_r, const Lanes& speed, const Lanes& stretch) {
  const Lanes trial = touching * (stretch + motion.step * speed);
  const Lanes limit = mu * normal / env.bed_stick;
  const Lanes size = trial > 0.0 ? trial : -trial;
  const Lanes sign = trial > 0.0 ? all(1.0) : all(-1.0);
  const Lanes sliding = size > limit ? all(1.0) : Lanes{};
  const Lanes next = sliding * sign * limit + (1.0 - sliding) * trial;
  load.f = load.f - (env.bed_stick * next) * direction;
  if constexpr (kTangent) {
    add_outer(load.in_r, -(1.0 - sliding) * touching * (env.bed_stick * motion.step * motion.velocity_share), direction,
              direction);
    add_outer(load.in_r, -sliding * sign * mu * normal_in_r, direction, n);
  }
  return next;
}

struct BedSlip {
  Lanes across, along;
};

/// The bed's normal force at moving points.
struct NormalForce {
  Lanes touching, approaching, size;
  Lanes in_r;       ///< Derivative of its size along the normal of a plane.
  Lanes stiffness;  ///< Of the soil.
};

/// What a shape adds to the normal force of a plane, and friction on it: clearance and normal have their own
/// derivatives, and the direction along the route turns with the bed.
template <bool kTangent>
inline BedSlip add_moving_shape(PointLoad<kTangent>& load, const LineEnvironment& env, const LineMotion& motion,
                                const MovingPoint& at, const BedUnder& bed, const NormalForce& normal,
                                const BedSlip& slip) {
  const Vec& n = bed.normal;
  const Vec more = -normal.stiffness * (bed.gradient - n) -
                   (env.bed_damping * normal.approaching) * transposed_times(bed.turn, at.v);
  if constexpr (kTangent) {
    add_outer(load.in_r, all(1.0), n, more);
    add_columns(load.in_r, normal.size, bed.turn);
  }
  BedSlip next{Lanes{}, Lanes{}};
  const auto hold = [&](const Vec& direction, double mu, const Lanes& stretch) {
    const Lanes speed = dot(direction, at.v);
    const Lanes held = add_bed_friction<kTangent>(load, env, motion, n, direction, mu, normal.touching, normal.size,
                                                  normal.in_r, speed, stretch);
    const Lanes trial = normal.touching * (stretch + motion.step * speed);
    const Lanes sliding = (trial > 0.0 ? trial : -trial) > mu * normal.size / env.bed_stick ? all(1.0) : Lanes{};
    if constexpr (kTangent) {
      add_outer(load.in_r, -sliding * (trial > 0.0 ? all(mu) : all(-mu)), direction, more);
    }
    return std::pair{held, sliding};
  };
  if (env.bed_friction_lateral > 0.0 && env.bed_stick > 0.0) {
    next.across = hold(across_route(env, at.r), env.bed_friction_lateral, slip.across).first;
  }
  if (env.bed_friction_axial > 0.0 && env.bed_stick > 0.0) {
    const AlongShape along = along_shape(env, at.r, bed);
    const auto [held, sliding] = hold(along.direction, env.bed_friction_axial, slip.along);
    next.along = held;
    if constexpr (kTangent) {
      add_columns(load.in_r, -env.bed_stick * held, along.turn);
      add_outer(load.in_r, (sliding - 1.0) * normal.touching * (env.bed_stick * motion.step), along.direction,
                transposed_times(along.turn, at.v));
    }
  }
  return next;
}

/// Normal penalty with damping on approach, never pulling, and friction across and along the route.
template <bool kTangent>
inline BedSlip add_moving_seabed(PointLoad<kTangent>& load, const LineEnvironment& env, const LineMotion& motion,
                                 const MovingPoint& at, const Lanes& radius, const BedSlip& slip) {
  const BedUnder bed = bed_under(env, at.r, radius);
  const Vec& n = bed.normal;
  const Lanes penetration = radius - bed.clearance;
  if (!any(penetration)) {
    return BedSlip{Lanes{}, Lanes{}};
  }
  const Lanes touching = penetration > 0.0 ? all(1.0) : Lanes{};
  const Lanes speed = -dot(n, at.v);
  const Lanes approaching = speed > 0.0 ? touching : Lanes{};
  Lanes normal = touching * env.bed_stiffness * penetration + approaching * env.bed_damping * speed;
  Lanes in_r = -(touching * env.bed_stiffness + approaching * (env.bed_damping * motion.velocity_share));
  Lanes stiffness = touching * env.bed_stiffness;
  if (env.bed_soil != 0) {
    const SoilForce soil = soil_force(env, touching, penetration);
    stiffness = soil.slope;
    normal = soil.force + approaching * env.bed_damping * speed;
    in_r = -(stiffness + approaching * (env.bed_damping * motion.velocity_share));
  }
  load.f = load.f + normal * n;
  if constexpr (kTangent) {
    add_outer(load.in_r, in_r, n, n);
  }
  if (env.bed_shape != nullptr) {
    return add_moving_shape<kTangent>(load, env, motion, at, bed, {touching, approaching, normal, in_r, stiffness},
                                      slip);
  }
  BedSlip next{Lanes{}, Lanes{}};
  if (env.bed_friction_lateral > 0.0 && env.bed_stick > 0.0) {
    const Vec across = across_route(env, at.r);
    next.across = add_bed_friction<kTangent>(load, env, motion, n, across, env.bed_friction_lateral, touching, normal,
                                             in_r, dot(across, at.v), slip.across);
  }
  if (env.bed_friction_axial > 0.0 && env.bed_stick > 0.0) {
    const Vec along = along_route(env, at.r);
    next.along = add_bed_friction<kTangent>(load, env, motion, n, along, env.bed_friction_axial, touching, normal, in_r,
                                            dot(along, at.v), slip.along);
  }
  return next;
}

inline Lanes* slip_at(double* slips, int point, int direction, int padded, int first) {
  return reinterpret_cast<Lanes*>(slips + (point * kBedDirections + direction) * padded + first);
}

/// Weight, buoyancy, seabed, water and inertia at Gauss point i of a batch that begins with element `first`.
template <bool kTangent>
inline PointLoad<kTangent> moving_load(const LineEnvironment& env, const LineMotion& motion, const MovingPoint& at,
                                       const PointSlope& slope, const LoadConstants& c, const InertiaConstants& inertia,
                                       int i, int first, int padded) {
  const Wetting wet = wetting(at.r.z - at.surface, c.radius);
  Vec f = -inertia.mass * at.acc;
  f.z += c.buoyancy * wet.share - c.weight;
  PointLoad<kTangent> load = load_of<kTangent>(f, c.buoyancy * wet.slope);
  if constexpr (kTangent) {
    for (int r = 0; r < 3; ++r) {
      load.in_r.m[r][r] -= motion.acceleration_share * inertia.mass;
    }
  }
  BedSlip slip{Lanes{}, Lanes{}};
  if (motion.bed_slip != nullptr) {
    double* slips = const_cast<double*>(motion.bed_slip);
    slip = {*slip_at(slips, i, 0, padded, first), *slip_at(slips, i, 1, padded, first)};
  }
  const BedSlip next = add_moving_seabed<kTangent>(load, env, motion, at, c.radius, slip);
  if (motion.bed_slip_next != nullptr) {
    *slip_at(motion.bed_slip_next, i, 0, padded, first) = next.across;
    *slip_at(motion.bed_slip_next, i, 1, padded, first) = next.along;
  }
  add_morison<kTangent>(load, env, motion, at, slope, wet, c, inertia);
  return load;
}

}  // namespace
}  // namespace overbend::OVERBEND_ISA_NAMESPACE
