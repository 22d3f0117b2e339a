/// Inertia, Morison's forces and seabed friction at the Gauss points of a moving batch, with their exact derivatives
/// and energies. For line_kernel.cpp only.
#pragma once

#include "mechanics/line_kernel_loads.h"

namespace overbend::OVERBEND_ISA_NAMESPACE {
namespace {

/// Water along the elements of a batch: value in the middle and change from end to end.
struct BatchWater {
  Vec velocity, acceleration;
  Lanes surface;  ///< Elevation [m].
};

/// Motion of a batch: velocity and acceleration along its elements, and of the water.
struct BatchMotion {
  Cubic v, acc;
  BatchWater middle, change;
  Lanes head[2];  ///< Head of the dynamic pressure at both ends [m].
};

/// Gathers the water at both ends, linear along an element; lanes beyond the last element repeat it.
inline void gather_water(BatchMotion& m, const double* water, int first, int count) {
  Lanes ends[2][kWaterValues];
  gather_ends<kWaterValues>(ends[0], ends[1], water, first, count);
  Lanes mean[kWaterValues], change[kWaterValues];
  for (int i = 0; i < kWaterValues; ++i) {
    mean[i] = 0.5 * (ends[0][i] + ends[1][i]);
    change[i] = ends[1][i] - ends[0][i];
  }
  m.middle = {{mean[0], mean[1], mean[2]}, {mean[3], mean[4], mean[5]}, mean[6]};
  m.change = {{change[0], change[1], change[2]}, {change[3], change[4], change[5]}, change[6]};
  m.head[0] = ends[0][7];
  m.head[1] = ends[1][7];
}

/// Returns the cubic of nodal values, six per node, along every element.
inline Cubic gather_cubic(const double* values, const Lanes& h, int first, int count) {
  Vec nodes[4];
  gather_nodes(nodes, values, first, count);
  nodes[1] = h * nodes[1];
  nodes[3] = h * nodes[3];
  return make_cubic(nodes);
}

inline void gather_motion(BatchMotion& m, const Lanes& h, const LineMotion& motion, int first, int count) {
  m.v = gather_cubic(motion.v, h, first, count);
  m.acc = gather_cubic(motion.acc, h, first, count);
  if (motion.water != nullptr) {
    return gather_water(m, motion.water, first, count);
  }
  m.middle = m.change = BatchWater{};
  m.head[0] = m.head[1] = Lanes{};
}

/// Constants of a moving batch in addition to LoadConstants.
struct InertiaConstants {
  Lanes mass, displaced, added_normal, added_axial;
};

/// Gauss point of a moving line and its waves. Each quantity is computed on use: all at once would exceed the
/// registers.
struct MovingPoint {
  const Batch& e;
  const BatchMotion& m;
  const GaussPoint& p;

  Vec v() const { return value_at(m.v, p); }
  Vec acc() const { return value_at(m.acc, p); }
  Vec water_v() const { return m.middle.velocity + p.y * m.change.velocity; }
  Vec water_a() const { return m.middle.acceleration + p.y * m.change.acceleration; }
  Lanes surface() const { return m.middle.surface + p.y * m.change.surface; }  ///< Elevation of the water [m].
};

/// Morison's force of moving water on the moving pipe: drag on the relative velocity and added mass on the relative
/// acceleration, each with its normal and tangential part, and the force rho A a_water of the pressure field that
/// accelerates the displaced water (Morison et al. 1950; DNV-RP-C205 section 6). The last acts in all directions: along
/// the pipe it is the gradient of the dynamic pressure that the effective tension contains. Times the wetted fraction.
/// Returns the force.
template <bool kTangent>
inline Vec add_morison(PointLoad<kTangent>& load, const LineEnvironment& env, const LineMotion& motion,
                       const MovingPoint& point, const Lanes& z, const PointSlope& slope, const Wetting& wet,
                       const LoadConstants& c, const InertiaConstants& i) {
  if (!any(wet.share)) {
    return Vec{};
  }
  const Vec t = slope.inv_norm * slope.a;
  const Vec water_a = point.water_a(), slip = water_a - point.acc();
  const Lanes more_along = i.added_axial - i.added_normal;
  const Lanes slip_t = more_along * dot(slip, t);
  Vec f = i.displaced * water_a + i.added_normal * slip;
  Vec u = point.water_v() - point.v();
  Vec current_slope{};
  if (env.current_rows > 0) {
    const Current current = current_at(env, z);
    u = u + current.velocity;
    current_slope = current.slope;
  }
  const Drag d = compute_drag<kTangent>(t, u, c.drag_normal, c.drag_axial);
  f = f + d.by_size * d.un + (d.by_along * d.ut + slip_t) * t;
  const Vec wetted = wet.share * f;
  load.f = load.f + wetted;
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
    add_sym(load.in_r, -wet.share, dyads(drag + added, drag_t + added_t - drag - added, t, drag, e, Lanes{}));
    add_turning(load.in_a, wet.share * slope.inv_norm, t, (2.0 * d.by_along - d.by_size) * u + more_along * slip,
                d.ut * (d.by_along - d.by_size) + slip_t, -d.ut * d.by_size, e);
  }
  return wetted;
}

/// Adds one direction of seabed friction: elastic slip up to mu times the normal force, then sliding (return mapping).
/// Returns the new elastic slip.
template <bool kTangent>
inline Lanes add_bed_friction(PointLoad<kTangent>& load, const LineEnvironment& env, const LineMotion& motion,
                              const Vec& n, const Vec& direction, double mu, const Lanes& touching, const Lanes& normal,
                              const Lanes& normal_in_r, const Lanes& speed, const Lanes& stretch) {
  const Lanes trial = touching * (stretch + motion.step * speed);
  const Lanes limit = (mu / env.bed_stick) * normal;
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

/// Normal force of the seabed at moving points.
struct NormalForce {
  Lanes touching, approaching;
  Lanes held;       ///< Spring force of the soil [N/m].
  Lanes size;       ///< Normal force including damping.
  Lanes in_r;       ///< Derivative of the normal force along the normal of a plane.
  Lanes stiffness;  ///< Stiffness of the soil.
};

/// Adds the terms of bathymetry to the normal force of a plane, and friction on it: clearance and normal have their own
/// derivatives, and the direction along the route varies with the seabed.
template <bool kTangent>
inline BedSlip add_moving_shape(PointLoad<kTangent>& load, const LineEnvironment& env, const LineMotion& motion,
                                const Vec& r, const Vec& v, const SeabedUnder& bed, const NormalForce& normal,
                                const BedSlip& slip) {
  const Vec& n = bed.normal;
  const Vec more =
      -normal.stiffness * (bed.gradient - n) - (env.bed_damping * normal.approaching) * transposed_times(bed.turn, v);
  if constexpr (kTangent) {
    add_outer(load.in_r, all(1.0), n, more);
    add_columns(load.in_r, normal.size, bed.turn);
  }
  BedSlip next{Lanes{}, Lanes{}};
  const auto hold = [&](const Vec& direction, double mu, const Lanes& stretch) {
    const Lanes speed = dot(direction, v);
    const Lanes held = add_bed_friction<kTangent>(load, env, motion, n, direction, mu, normal.touching, normal.size,
                                                  normal.in_r, speed, stretch);
    const Lanes trial = normal.touching * (stretch + motion.step * speed);
    const Lanes sliding = (trial > 0.0 ? trial : -trial) > (mu / env.bed_stick) * normal.size ? all(1.0) : Lanes{};
    if constexpr (kTangent) {
      add_outer(load.in_r, -sliding * (trial > 0.0 ? all(mu) : all(-mu)), direction, more);
    }
    return std::pair{held, sliding};
  };
  if (env.bed_friction_lateral > 0.0 && env.bed_stick > 0.0) {
    next.across = hold(across_route(env, r), env.bed_friction_lateral, slip.across).first;
  }
  if (env.bed_friction_axial > 0.0 && env.bed_stick > 0.0) {
    const AlongShape along = along_shape(env, r, bed);
    const auto [held, sliding] = hold(along.direction, env.bed_friction_axial, slip.along);
    next.along = held;
    if constexpr (kTangent) {
      add_columns(load.in_r, -env.bed_stick * held, along.turn);
      add_outer(load.in_r, (sliding - 1.0) * normal.touching * (env.bed_stick * motion.step), along.direction,
                transposed_times(along.turn, v));
    }
  }
  return next;
}

/// Energy and dissipation of the seabed at a point; elastic friction slip counts as dissipated.
inline void add_bed_energy(const EnergySums& energy, const Lanes& w, const LineEnvironment& env, const Vec& r,
                           const Vec& v, const SeabedUnder& bed, const NormalForce& normal, const Lanes& penetration,
                           const BedSlip& slip) {
  EnergyLanes& sum = *energy.sum;
  const Lanes speed = dot(bed.normal, v), held = normal.held;
  Lanes loss = normal.approaching * env.bed_damping * speed * speed;
  if (env.bed_soil != 0) {
    sum.seabed += w * soil_force(env, normal.touching, penetration).energy;
  } else {
    sum.seabed += 0.5 * w * held * penetration;
  }
  Vec along = along_route(env, r);
  if (env.bed_shape != nullptr) {  // the force of a curved seabed has no potential: the difference counts as dissipated
    along = along_shape(env, r, bed).direction;
    loss += held * dot(bed.gradient - bed.normal, v);
  }
  loss += env.bed_stick * (slip.across * dot(across_route(env, r), v) + slip.along * dot(along, v));
  sum.seabed_loss += w * loss;
}

/// Adds the normal penalty with damping on approach, never pulling, and friction across and along the route; `slip` is
/// updated to the elastic slip after the step.
template <bool kTangent, bool kEnergy>
inline void add_moving_seabed(PointLoad<kTangent>& load, const LineEnvironment& env, const LineMotion& motion,
                              const EnergySums& energy, const Lanes& w, const Vec& r, const Vec& v, const Lanes& radius,
                              BedSlip& slip) {
  const SeabedUnder bed = bed_under(env, r, radius);
  const Vec& n = bed.normal;
  const Lanes penetration = radius - bed.clearance;
  const Lanes speed = -dot(n, v);
  NormalForce normal;
  normal.touching = penetration > 0.0 ? all(1.0) : Lanes{};
  normal.approaching = speed > 0.0 ? normal.touching : Lanes{};
  normal.stiffness = normal.touching * env.bed_stiffness;
  normal.held = normal.stiffness * penetration;
  if (env.bed_soil != 0) {
    const SoilForce soil = soil_force(env, normal.touching, penetration);
    normal.stiffness = soil.slope;
    normal.held = soil.force;
  }
  normal.size = normal.held + normal.approaching * env.bed_damping * speed;
  normal.in_r = -(normal.stiffness + normal.approaching * (env.bed_damping * motion.velocity_share));
  load.f = load.f + normal.size * n;
  if constexpr (kTangent) {
    add_outer(load.in_r, normal.in_r, n, n);
  }
  BedSlip next{Lanes{}, Lanes{}};
  if (env.bed_shape != nullptr) {
    next = add_moving_shape<kTangent>(load, env, motion, r, v, bed, normal, slip);
  } else {
    const auto hold = [&](const Vec& direction, double mu, const Lanes& stretch) {
      return add_bed_friction<kTangent>(load, env, motion, n, direction, mu, normal.touching, normal.size, normal.in_r,
                                        dot(direction, v), stretch);
    };
    if (env.bed_friction_lateral > 0.0 && env.bed_stick > 0.0) {
      next.across = hold(across_route(env, r), env.bed_friction_lateral, slip.across);
    }
    if (env.bed_friction_axial > 0.0 && env.bed_stick > 0.0) {
      next.along = hold(along_route(env, r), env.bed_friction_axial, slip.along);
    }
  }
  slip = next;
  if constexpr (kEnergy) {
    add_bed_energy(energy, w, env, r, v, bed, normal, penetration, slip);
  }
}

/// Returns the elastic slip of the seabed friction at Gauss point i of a batch that begins with element `first`.
inline Lanes* slip_at(double* slips, int i, int direction, int padded, int first) {
  return reinterpret_cast<Lanes*>(slips + (i * kBedDirections + direction) * padded + first);
}

/// Returns weight, buoyancy, seabed, water and inertia at Gauss point i of a batch that begins with element `first`,
/// and with kEnergy adds the energies.
template <bool kTangent, bool kEnergy>
inline PointLoad<kTangent> moving_load(const LineEnvironment& env, const LineMotion& motion, const EnergySums& energy,
                                       const MovingPoint& point, const PointSlope& slope, const LoadConstants& c,
                                       const InertiaConstants& inertia, int i, int first, int padded) {
  const Vec r = value_at(point.e.r, point.p);
  const Wetting wet = wetting(r.z - point.surface(), c.radius);
  const Lanes lift = c.buoyancy * wet.share, w = point.p.weight * energy.counts;
  Vec f = -inertia.mass * point.acc();
  f.z += lift - c.weight;
  PointLoad<kTangent> load = make_height_load<kTangent>(f, c.buoyancy * wet.slope);
  if constexpr (kTangent) {
    for (int k = 0; k < 3; ++k) {
      load.in_r.m[k][k] -= motion.acceleration_share * inertia.mass;
    }
  }
  BedSlip slip{Lanes{}, Lanes{}};
  if (near_bed(env, r, c.radius)) {
    if (motion.bed_slip != nullptr) {
      double* slips = const_cast<double*>(motion.bed_slip);
      slip = {*slip_at(slips, i, 0, padded, first), *slip_at(slips, i, 1, padded, first)};
    }
    add_moving_seabed<kTangent, kEnergy>(load, env, motion, energy, w, r, point.v(), c.radius, slip);
  }
  if (motion.bed_slip_next != nullptr) {
    *slip_at(motion.bed_slip_next, i, 0, padded, first) = slip.across;
    *slip_at(motion.bed_slip_next, i, 1, padded, first) = slip.along;
  }
  const Vec water = add_morison<kTangent>(load, env, motion, point, r.z, slope, wet, c, inertia);
  if constexpr (kEnergy) {
    const Vec v = point.v();
    energy.sum->kinetic += 0.5 * w * inertia.mass * dot(v, v);
    energy.sum->gravity += w * c.weight * r.z;
    energy.sum->fluid_power += w * (dot(water, v) + lift * v.z);
  }
  return load;
}

}  // namespace
}  // namespace overbend::OVERBEND_ISA_NAMESPACE
