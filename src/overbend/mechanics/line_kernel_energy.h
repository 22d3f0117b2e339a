/// Energies and powers of a batch in motion. For line_kernel.cpp alone.
#pragma once

#include "mechanics/line_kernel_motion.h"

namespace overbend::OVERBEND_ISA_NAMESPACE {
namespace {

/// As LineEnergy, of every lane apart: added up at the end of the line.
struct EnergyLanes {
  Lanes kinetic{}, strain{}, gravity{}, seabed{}, fluid_power{}, seabed_loss{};
};

/// What the bed stores and takes at a Gauss point that counts for the length `w`. The loss counts the stretch of its
/// friction as lost.
inline void add_bed_energy(EnergyLanes& sum, const LineEnvironment& env, const LineMotion& motion,
                           const MovingPoint& at, const Lanes& radius, const Lanes& w, int i, int first, int padded) {
  const BedUnder bed = bed_under(env, at.r, radius);
  const Vec& n = bed.normal;
  const Lanes penetration = radius - bed.clearance;
  if (!any(penetration)) {
    return;
  }
  const Lanes touching = penetration > 0.0 ? all(1.0) : Lanes{};
  const Lanes speed = -dot(n, at.v);
  const Lanes damping = speed > 0.0 ? touching * env.bed_damping * speed * speed : Lanes{};
  Lanes held = touching * env.bed_stiffness * penetration;
  if (env.bed_soil != 0) {
    const SoilForce soil = soil_force(env, touching, penetration);
    held = soil.force;
    sum.seabed += w * soil.energy;
  } else {
    sum.seabed += 0.5 * w * env.bed_stiffness * touching * penetration * penetration;
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
  sum.seabed_loss += w * loss;
}

/// `counts`: the length of every element, 0 of those that fill the batch up.
inline void add_energy(EnergyLanes& sum, const Batch& e, const LineEnvironment& env, const LineMotion& motion,
                       const BatchMotion& m, const LoadConstants& c, const InertiaConstants& inertia, const Lanes& EI,
                       const Lanes& counts, int first, int padded) {
  for (int i = 0; i < kGaussPoints; ++i) {
    const Shape& s = kGaussShape[i];
    const MovingPoint at = moving_point(e, m, s, kGaussXi[i]);
    const PointSlope slope = slope_at(e, s);
    const Lanes w = kGaussWeight[i] * counts;
    sum.kinetic += 0.5 * w * inertia.mass * dot(at.v, at.v);
    sum.gravity += w * c.weight * at.r.z;
    const Vec b = (e.inv_h * e.inv_h) * combine_derivative(e, s.d);
    const Lanes ab = dot(slope.a, b) * slope.inv_g;
    sum.strain += 0.5 * w * EI * (dot(b, b) * slope.inv_g - ab * ab);
    const Wetting wet = wetting(at.r.z - at.surface, c.radius);
    PointLoad<false> water{{Lanes{}, Lanes{}, c.buoyancy * wet.share}};
    add_morison<false>(water, env, motion, at, slope, wet, c, inertia);
    sum.fluid_power += w * dot(water.f, at.v);
    add_bed_energy(sum, env, motion, at, c.radius, w, i, first, padded);
  }
}

/// Membrane energy, and the power of pressure on the changing length, which counts as the water's.
inline void add_membrane_energy(EnergyLanes& sum, const Batch& e, const BatchMotion& m, const Lanes& EA,
                                const PressureTension& pressure, const Lanes& counts) {
  const Membrane at = membrane_of(e, pressure, m.head);
  Lanes rate[3];
  for (int k = 0; k < 3; ++k) {
    rate[k] = dot(at.u[k], e.inv_h * combine_nodes(m.v, kStrainShape[k].c));
  }
  for (int k = 0; k < 3; ++k) {
    for (int l = 0; l < 3; ++l) {
      const Lanes w = kStrainMass[k][l] * counts;
      sum.strain += 0.5 * w * EA * at.strain[k] * at.strain[l];
      sum.fluid_power -= w * at.tension[k] * rate[l];
    }
  }
}

inline double sum_of(const Lanes& x) {
  double sum = 0.0;
  for (int l = 0; l < kWidth; ++l) {
    sum += x[l];
  }
  return sum;
}

}  // namespace
}  // namespace overbend::OVERBEND_ISA_NAMESPACE
