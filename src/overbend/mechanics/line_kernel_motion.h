/// Inertia, Morison's forces and the bed's friction at the Gauss points of a batch in motion, with their exact
/// derivatives; energies. For line_kernel.cpp alone.
#pragma once

#include "mechanics/line_kernel_loads.h"

namespace overbend::OVERBEND_ISA_NAMESPACE {
namespace {

inline constexpr int kTangentNodes[2] = {1, 3};  ///< Which of r1, t1, r2, t2 are tangents.

/// Motion of a batch: like Batch::q, tangents scaled by the element length; water at both ends.
struct BatchMotion {
  Vec v[4] = {}, acc[4] = {};
  Vec water_v[2] = {}, water_a[2] = {};
  Lanes surface[2] = {};
  Lanes head[2] = {};
};

inline void gather_motion(BatchMotion& m, const Lanes& h, const LineMotion& motion, int first, int count) {
  gather_nodes(m.v, motion.v, first, count);
  gather_nodes(m.acc, motion.acc, first, count);
  for (const int tangent : kTangentNodes) {
    m.v[tangent] = h * m.v[tangent];
    m.acc[tangent] = h * m.acc[tangent];
  }
  for (int end = 0; end < 2; ++end) {
    m.water_v[end] = m.water_a[end] = Vec{};
    m.surface[end] = m.head[end] = Lanes{};
    if (motion.water == nullptr) {
      continue;
    }
    for (int l = 0; l < kWidth; ++l) {
      const double* w = motion.water + kWaterValues * ((first + l < count ? first + l : count - 1) + end);
      m.water_v[end].x[l] = w[0];
      m.water_v[end].y[l] = w[1];
      m.water_v[end].z[l] = w[2];
      m.water_a[end].x[l] = w[3];
      m.water_a[end].y[l] = w[4];
      m.water_a[end].z[l] = w[5];
      m.surface[end][l] = w[6];
      m.head[end][l] = w[7];
    }
  }
}

inline Vec combine_nodes(const Vec (&nodes)[4], const double (&s)[4]) {
  return s[0] * nodes[0] + s[1] * nodes[1] + s[2] * nodes[2] + s[3] * nodes[3];
}

/// Constants of a moving batch beside LoadConstants.
struct InertiaConstants {
  Lanes mass, displaced, added_normal, added_axial;
};

/// Loads and motion at a Gauss point of a moving line.
struct MovingPoint {
  Vec r, a, v, acc;
  Vec water_v, water_a;  ///< Waves alone.
  Lanes surface;         ///< Elevation of the water [m].
};

/// Linear between the values at both ends.
inline Lanes mixed(const Lanes (&ends)[2], double xi) {
  return (1.0 - xi) * ends[0] + xi * ends[1];
}

inline MovingPoint moving_point(const Batch& e, const BatchMotion& m, const Shape& s, double xi) {
  MovingPoint at;
  at.r = combine(e, s.n);
  at.a = e.inv_h * combine_derivative(e, s.c);
  at.v = combine_nodes(m.v, s.n);
  at.acc = combine_nodes(m.acc, s.n);
  at.water_v = (1.0 - xi) * m.water_v[0] + xi * m.water_v[1];
  at.water_a = (1.0 - xi) * m.water_a[0] + xi * m.water_a[1];
  at.surface = mixed(m.surface, xi);
  return at;
}

inline Sym identity_and(const Lanes& alpha, const Lanes& beta, const Vec& t) {
  return dyads(alpha, beta, t, Lanes{}, t, Lanes{});
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
inline void add_morison(PointLoad& load, const LineEnvironment& env, const LineMotion& motion, const MovingPoint& at,
                        const Wetting& wet, const LoadConstants& c, const InertiaConstants& i) {
  if (!any(wet.share)) {
    return;
  }
  Current now{};
  if (env.current_rows > 0) {
    now = current_at(env, at.r.z);
  }
  const Lanes inv_norm = 1.0 / root(dot(at.a, at.a));
  const Vec t = inv_norm * at.a;
  const Vec u = now.velocity + at.water_v - at.v;
  const Lanes ut = dot(u, t);
  const Vec un = u - ut * t;
  const Lanes size = root(dot(un, un)) + 1e-30;  // water along the pipe has no normal drag, not 0/0
  const Lanes along = ut > 0.0 ? ut : -ut;
  const Vec slip_a = at.water_a - at.acc;
  const Lanes more_along = i.added_axial - i.added_normal;
  const Lanes slip_t = dot(slip_a, t);
  const Vec f = (c.drag_normal * size) * un + (c.drag_axial * along * ut + more_along * slip_t) * t +
                i.displaced * at.water_a + i.added_normal * slip_a;
  load.f = load.f + wet.share * f;
  if constexpr (kTangent) {
    const Vec e = (1.0 / size) * un;
    const auto jacobian_n = [&](const Vec& v) { return c.drag_normal * (size * v + (size * dot(e, v)) * e); };
    const Vec slope_n = now.slope - dot(now.slope, t) * t;
    const Vec in_z = jacobian_n(slope_n) + (2.0 * c.drag_axial * along * dot(now.slope, t)) * t;
    const Vec z_column = wet.share * in_z + wet.slope * f;
    load.in_r.m[0][2] += z_column.x;
    load.in_r.m[1][2] += z_column.y;
    load.in_r.m[2][2] += z_column.z;
    // By the velocity: -[Cn |un| (I - t t' + e e') + 2 Ct |ut| t t']; by the acceleration: -[Ca (I - t t') + Ct_a t
    // t'].
    const Lanes drag = motion.velocity_share * c.drag_normal * size;
    const Lanes drag_t = 2.0 * motion.velocity_share * c.drag_axial * along;
    const Lanes added = motion.acceleration_share * i.added_normal;
    const Lanes added_t = motion.acceleration_share * i.added_axial;
    add_sym(load.in_r, -wet.share, dyads(drag + added, drag_t + added_t - drag - added, t, drag, e, Lanes{}));
    const Vec axes[3] = {{all(1.0), Lanes{}, Lanes{}}, {Lanes{}, all(1.0), Lanes{}}, {Lanes{}, Lanes{}, all(1.0)}};
    const Lanes scale = wet.share * inv_norm;
    for (int k = 0; k < 3; ++k) {
      const Vec dt = axes[k] - dot(axes[k], t) * t;  // times inv_norm: change of t with a_k
      const Lanes dut = dot(u, dt);
      const Vec dun = (-1.0 * dut) * t - ut * dt;
      const Vec df = jacobian_n(dun) + (2.0 * c.drag_axial * along * dut + more_along * dot(slip_a, dt)) * t +
                     (c.drag_axial * along * ut + more_along * slip_t) * dt;
      load.in_a.m[0][k] += scale * df.x;
      load.in_a.m[1][k] += scale * df.y;
      load.in_a.m[2][k] += scale * df.z;
    }
  }
}

/// One direction of the bed's friction: elastic stretch up to mu times the normal force, then sliding (return mapping).
/// Returns the new stretch.
template <bool kTangent>
inline Lanes add_bed_friction(PointLoad& load, const LineEnvironment& env, const LineMotion& motion, const Vec& n,
                              const Vec& direction, double mu, const Lanes& touching, const Lanes& normal,
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
inline BedSlip add_moving_shape(PointLoad& load, const LineEnvironment& env, const LineMotion& motion,
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
inline BedSlip add_moving_seabed(PointLoad& load, const LineEnvironment& env, const LineMotion& motion,
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

/// Weight, buoyancy, seabed, water and inertia by Gauss points; external forces enter the residual with a minus sign.
template <bool kTangent>
inline void add_moving_loads(Batch& e, const LineEnvironment& env, const LineMotion& motion, const BatchMotion& m,
                             const LoadConstants& c, const InertiaConstants& inertia, int first, int padded) {
  for (int i = 0; i < kGaussPoints; ++i) {
    const Shape& s = kGaussShape[i];
    const MovingPoint at = moving_point(e, m, s, kGaussXi[i]);
    const Wetting wet = wetting(at.r.z - at.surface, c.radius);
    PointLoad load{};
    load.f = -1.0 * (inertia.mass * at.acc);
    load.f.z += c.buoyancy * wet.share - c.weight;
    if constexpr (kTangent) {
      const Lanes m_share = motion.acceleration_share * inertia.mass;
      load.in_r.m[0][0] = load.in_r.m[1][1] = -m_share;
      load.in_r.m[2][2] = c.buoyancy * wet.slope - m_share;
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
    add_morison<kTangent>(load, env, motion, at, wet, c, inertia);
    add_point_load<kTangent>(e, i, load);
  }
}

inline double sum_of(const Lanes& x, int used) {
  double sum = 0.0;
  for (int l = 0; l < used; ++l) {
    sum += x[l];
  }
  return sum;
}

/// Energies and powers of a batch. The bed's loss counts the stretch of its friction as lost.
inline void add_energy(LineEnergy& sum, const Batch& e, const LineEnvironment& env, const LineMotion& motion,
                       const BatchMotion& m, const LoadConstants& c, const InertiaConstants& inertia, const Lanes& EI,
                       int first, int padded, int used) {
  for (int i = 0; i < kGaussPoints; ++i) {
    const Shape& s = kGaussShape[i];
    const MovingPoint at = moving_point(e, m, s, kGaussXi[i]);
    const Lanes w = kGaussWeight[i] * e.h;
    sum.kinetic += sum_of(0.5 * w * inertia.mass * dot(at.v, at.v), used);
    sum.gravity += sum_of(w * c.weight * at.r.z, used);
    const Vec b = (e.inv_h * e.inv_h) * combine_derivative(e, s.d);
    const Lanes g = dot(at.a, at.a), ab = dot(at.a, b);
    sum.strain += sum_of(0.5 * w * EI * (dot(b, b) / g - ab * ab / (g * g)), used);

    PointLoad water{};
    const Wetting wet = wetting(at.r.z - at.surface, c.radius);
    water.f.z = c.buoyancy * wet.share;
    add_morison<false>(water, env, motion, at, wet, c, inertia);
    sum.fluid_power += sum_of(w * dot(water.f, at.v), used);

    const BedUnder bed = bed_under(env, at.r, c.radius);
    const Vec& n = bed.normal;
    const Lanes penetration = c.radius - bed.clearance;
    if (!any(penetration)) {
      continue;
    }
    const Lanes touching = penetration > 0.0 ? all(1.0) : Lanes{};
    const Lanes speed = -dot(n, at.v);
    const Lanes damping = speed > 0.0 ? touching * env.bed_damping * speed * speed : Lanes{};
    Lanes held = touching * env.bed_stiffness * penetration;
    if (env.bed_soil != 0) {
      const SoilForce soil = soil_force(env, touching, penetration);
      held = soil.force;
      sum.seabed += sum_of(w * soil.energy, used);
    } else {
      sum.seabed += sum_of(0.5 * w * env.bed_stiffness * touching * penetration * penetration, used);
    }
    Lanes loss = damping;
    Vec along = along_route(env, at.r);
    if (env.bed_shape != nullptr) {  // the force of a curved bed has no potential: what it is off counts as lost
      along = along_shape(env, at.r, bed).direction;
      loss += held * dot(bed.gradient - n, at.v);
    }
    if (motion.bed_slip != nullptr) {
      double* slips = const_cast<double*>(motion.bed_slip);
      loss += env.bed_stick * (*slip_at(slips, i, 0, padded, first) * dot(across_route(env, at.r), at.v) +
                               *slip_at(slips, i, 1, padded, first) * dot(along, at.v));
    }
    sum.seabed_loss += sum_of(w * loss, used);
  }
}

}  // namespace
}  // namespace overbend::OVERBEND_ISA_NAMESPACE
