/// Energies and powers of a batch in motion, made beside its forces. For line_kernel.cpp alone.
#pragma once

#include "mechanics/line_kernel_strain.h"

namespace overbend::OVERBEND_ISA_NAMESPACE {
namespace {

/// As LineEnergy, of every lane apart: added up at the end of the line.
struct EnergyLanes {
  Lanes kinetic{}, strain{}, gravity{}, seabed{}, fluid_power{}, seabed_loss{};
};

/// Where the energies of a batch go, and the length of every element: 0 of those that fill the batch up.
struct EnergySums {
  EnergyLanes* sum;
  Lanes counts;
};

/// Membrane energy, and the power of pressure on the changing length, which counts as the water's.
inline void add_membrane_energy(const EnergySums& energy, const Batch& e, const Cubic& v, const Lanes& EA,
                                const Membrane& at) {
  const Lanes rate[3] = {e.inv_h * dot(at.u[0], slope_of(v, -0.5)), e.inv_h * dot(at.u[1], v.c1),
                         e.inv_h * dot(at.u[2], slope_of(v, 0.5))};
  for (int k = 0; k < 3; ++k) {
    Lanes strain{}, pressure{};
    for (int l = 0; l < 3; ++l) {
      strain += kStrainMass[k][l] * at.strain[l];
      pressure += kStrainMass[k][l] * at.tension[l];
    }
    energy.sum->strain += 0.5 * energy.counts * EA * at.strain[k] * strain;
    energy.sum->fluid_power -= energy.counts * pressure * rate[k];
  }
}

inline double sum_of(const Lanes& x) {
  double sum = 0.0;
  for (int l = 0; l < kWidth; ++l) {
    sum += x[l];
  }
  return sum;
}

inline LineEnergy sum_of(const EnergyLanes& lanes) {
  return {sum_of(lanes.kinetic), sum_of(lanes.strain),      sum_of(lanes.gravity),
          sum_of(lanes.seabed),  sum_of(lanes.fluid_power), sum_of(lanes.seabed_loss)};
}

}  // namespace
}  // namespace overbend::OVERBEND_ISA_NAMESPACE
