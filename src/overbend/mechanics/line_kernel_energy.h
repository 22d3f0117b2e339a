/// Energies and powers of a batch in motion, computed with its forces. For line_kernel.cpp only.
#pragma once

#include "mechanics/line_kernel_strain.h"

namespace overbend::OVERBEND_ISA_NAMESPACE {
namespace {

/// Members of LineEnergy by lane, summed at the end of the line.
struct EnergyLanes {
  Lanes kinetic{}, strain{}, gravity{}, seabed{}, fluid_power{}, seabed_loss{}, line_loss{};
};

/// Output energies of a batch, and the length of every element: 0 for padding elements.
struct EnergySums {
  EnergyLanes* sum;
  Lanes counts;
};

/// Slopes of a cubic with xi at the three strain points.
struct StrainSlopes {
  Vec at[3];
};
inline StrainSlopes slopes_at_strains(const Cubic& v) {
  return {{cubic_slope(v, -0.5), v.c1, cubic_slope(v, 0.5)}};
}

/// Adds the membrane energy, its dissipation by damping, and the power of pressure on the changing length, which counts
/// as fluid power. The membrane must have its rates.
inline void add_membrane_energy(const EnergySums& energy, const AxialConstants& axial, const Membrane& membrane) {
  const Lanes rest = 1.0 - axial.share;
  for (int k = 0; k < 3; ++k) {
    Lanes strain{}, pressure{};
    for (int l = 0; l < 3; ++l) {
      strain += kStrainMass[k][l] * membrane.strain[l];
      pressure += kStrainMass[k][l] * membrane.tension[l];
    }
    const Lanes weight = energy.counts * axial.EA, linear = membrane.strain[k] * strain;
    const Lanes slack = kSlackWeight[k] * twice_slack_energy(membrane.strain[k], axial.share);
    const Lanes ahead = tension_only_law(membrane.strain[k] + axial.damping * membrane.rate[k]).force;
    energy.sum->strain += 0.5 * weight * (rest > 0.0 ? slack : linear);
    energy.sum->line_loss +=
        kSlackWeight[k] * weight * rest * (ahead - tension_only_law(membrane.strain[k]).force) * membrane.rate[k];
    energy.sum->fluid_power -= energy.counts * pressure * membrane.rate[k];
  }
}

inline double lane_sum(const Lanes& x) {
  double sum = 0.0;
  for (int l = 0; l < kWidth; ++l) {
    sum += x[l];
  }
  return sum;
}

inline LineEnergy lane_sum(const EnergyLanes& lanes) {
  return {lane_sum(lanes.kinetic),     lane_sum(lanes.strain),      lane_sum(lanes.gravity),  lane_sum(lanes.seabed),
          lane_sum(lanes.fluid_power), lane_sum(lanes.seabed_loss), lane_sum(lanes.line_loss)};
}

}  // namespace
}  // namespace overbend::OVERBEND_ISA_NAMESPACE
