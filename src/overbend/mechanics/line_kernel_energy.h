/// Energies and powers of a batch in motion, made beside its forces. For line_kernel.cpp alone.
#pragma once

#include "mechanics/line_kernel_strain.h"

namespace overbend::OVERBEND_ISA_NAMESPACE {
namespace {

/// As LineEnergy, of every lane apart: added up at the end of the line.
struct EnergyLanes {
  Lanes kinetic{}, strain{}, gravity{}, seabed{}, fluid_power{}, seabed_loss{}, line_loss{};
};

/// Where the energies of a batch go, and the length of every element: 0 of those that fill the batch up.
struct EnergySums {
  EnergyLanes* sum;
  Lanes counts;
};

/// Slopes by xi of a cubic at the three strains.
struct StrainSlopes {
  Vec at[3];
};
inline StrainSlopes slopes_at_strains(const Cubic& v) {
  return {{slope_of(v, -0.5), v.c1, slope_of(v, 0.5)}};
}

/// Membrane energy and what damping takes of it, and the power of pressure on the changing length, which counts as the
/// water's. The membrane has its rates.
inline void add_membrane_energy(const EnergySums& energy, const AxialConstants& axial, const Membrane& at) {
  const Lanes rest = 1.0 - axial.share;
  for (int k = 0; k < 3; ++k) {
    Lanes strain{}, pressure{};
    for (int l = 0; l < 3; ++l) {
      strain += kStrainMass[k][l] * at.strain[l];
      pressure += kStrainMass[k][l] * at.tension[l];
    }
    const Lanes weight = energy.counts * axial.EA, linear = at.strain[k] * strain;
    const Lanes own = kSlackWeight[k] * twice_slack_energy(at.strain[k], axial.share);
    const Lanes ahead = pulling_law(at.strain[k] + axial.damping * at.rate[k]).force;
    energy.sum->strain += 0.5 * weight * (rest > 0.0 ? own : linear);
    energy.sum->line_loss += kSlackWeight[k] * weight * rest * (ahead - pulling_law(at.strain[k]).force) * at.rate[k];
    energy.sum->fluid_power -= energy.counts * pressure * at.rate[k];
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
  return {sum_of(lanes.kinetic),     sum_of(lanes.strain),      sum_of(lanes.gravity),  sum_of(lanes.seabed),
          sum_of(lanes.fluid_power), sum_of(lanes.seabed_loss), sum_of(lanes.line_loss)};
}

}  // namespace
}  // namespace overbend::OVERBEND_ISA_NAMESPACE
