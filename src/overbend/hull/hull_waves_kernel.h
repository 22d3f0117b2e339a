/// Sums over the wave components for wave forces and for the water velocity at the strips of a hull. Compiled once per
/// instruction set (base/simd.h); raw pointers only.
#pragma once

namespace overbend {

/// Components padded to whole batches of eight with zero amplitude.
struct HullWaveView {
  int count = 0;
  const double *omega, *kx, *ky, *phase;
  const double* direction;  ///< Direction the waves go to, anticlockwise from W's x [rad].
  const double* orbital;    ///< Horizontal velocity averaged over the draught [m/s].
  int headings = 0;
  bool all_around = false;
  bool drift = false;     ///< True if the slow variation of the drift is required.
  const double* heading;  ///< Ascending [rad].
  const double* table;    ///< [component][heading]: 8 real parts, 8 imaginary parts, 8 of the drift.
};

inline constexpr int kHullWaveRow = 24;  ///< Number of doubles per component and heading.

/// Time [s] and low-frequency position [m] and heading [rad].
struct HullWavePlace {
  double t = 0.0, x = 0.0, y = 0.0, psi = 0.0;
};

/// `out`: 8 of the first-order force (surge to yaw), 8 of the drift with its slow variation, 8 of the mean drift
/// (surge, sway, yaw, padding).
using HullWaveSums = void (*)(const HullWaveView& waves, const HullWavePlace& place, double* out);
/// `along`, `across`: velocities at `strips` (up to eight) points on the centreline.
using HullStripSums = void (*)(const HullWaveView& waves, const HullWavePlace& place, double first, double spacing,
                               int strips, double* along, double* across);

#define OVERBEND_HULL_WAVE_KERNEL(isa)                                                                      \
  namespace isa {                                                                                           \
  void sum_hull_waves(const HullWaveView& waves, const HullWavePlace& place, double* out);                  \
  void sum_strip_water(const HullWaveView& waves, const HullWavePlace& place, double first, double spacing, \
                       int strips, double* along, double* across);                                          \
  }
OVERBEND_HULL_WAVE_KERNEL(isa_baseline)
OVERBEND_HULL_WAVE_KERNEL(isa_avx2)
OVERBEND_HULL_WAVE_KERNEL(isa_avx512)
#undef OVERBEND_HULL_WAVE_KERNEL

}  // namespace overbend
