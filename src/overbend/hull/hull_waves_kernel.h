/// Sums over the components of the sea for wave forces and the water at the strips of a hull. Compiled once per
/// instruction set (base/simd.h); raw pointers only.
#pragma once

namespace overbend {

/// Components padded to whole batches of eight with components of no amplitude.
struct HullWaveView {
  int count = 0;
  const double *omega, *kx, *ky, *phase;
  const double* direction;  ///< Of travel, anticlockwise from W's x [rad].
  const double* orbital;    ///< Horizontal velocity averaged over the draught [m/s].
  int headings = 0;
  bool all_around = false;
  bool drift = false;     ///< Whether the drift's slow variation is wanted.
  const double* heading;  ///< Rising [rad].
  const double* table;    ///< [component][heading]: 8 real parts, 8 imaginary parts, 8 of the drift.
};

inline constexpr int kHullWaveRow = 24;  ///< Doubles a component and heading.

struct HullWavePlace {
  double t = 0.0, x = 0.0, y = 0.0, psi = 0.0;
};

/// `out`: 8 of the first-order force (surge to yaw), 8 of drift with its slow variation, 8 of the mean drift (surge,
/// sway, yaw and nothing).
using HullWaveSums = void (*)(const HullWaveView& waves, const HullWavePlace& at, double* out);
/// `along`, `across`: velocities at `strips` (up to eight) places on the centreline.
using HullStripSums = void (*)(const HullWaveView& waves, const HullWavePlace& at, double first, double spacing,
                               int strips, double* along, double* across);

#define OVERBEND_HULL_WAVE_KERNEL(isa)                                                                               \
  namespace isa {                                                                                                    \
  void sum_hull_waves(const HullWaveView& waves, const HullWavePlace& at, double* out);                              \
  void sum_strip_water(const HullWaveView& waves, const HullWavePlace& at, double first, double spacing, int strips, \
                       double* along, double* across);                                                               \
  }
OVERBEND_HULL_WAVE_KERNEL(isa_baseline)
OVERBEND_HULL_WAVE_KERNEL(isa_avx2)
OVERBEND_HULL_WAVE_KERNEL(isa_avx512)
#undef OVERBEND_HULL_WAVE_KERNEL

}  // namespace overbend
