/// First-order wave forces and drift of the hull from the same wave components as the loads on the lines.
#pragma once

#include <vector>

#include "base/aligned.h"
#include "hull/hull_current.h"
#include "mechanics/build_up.h"
#include "mechanics/sea.h"
#include "model/description/hull_description.h"
#include "model/description/hydrodynamic_data.h"

namespace overbend {

/// Made by make_hull_waves.
struct HullWaves {
  WaveDrift drift = WaveDrift::newman;
  int count = 0;                ///< Number of components, including padding.
  AlignedDoubles components;    ///< omega, kx, ky, phase, direction, orbital speed; one column each.
  AlignedDoubles table;         ///< [component][heading][force re, im, drift] of eight doubles each.
  std::vector<double> heading;  ///< Ascending [rad].
  bool all_around = false;      ///< The headings cover the full circle.
  /// Shares of the sea's variance outside the frequencies of the force [-].
  double below_table = 0.0, above_table = 0.0;
  /// The same above the frequencies of the drift, where waves cause no drift [-].
  double above_drift = 0.0;

  bool empty() const { return count == 0; }
};

/// Returns tables of excitation and drift at the components of a sea, interpolated linearly in frequency, real and
/// imaginary parts separately; constant below the file's first frequency, zero above its last. `draught` [m]: depth
/// over which the water velocity is averaged. Throws std::invalid_argument if the file's headings, relative to the hull
/// heading `psi` [rad], do not cover those of the components.
HullWaves make_hull_waves(const HydrodynamicData& data, const Sea& sea, WaveDrift drift, double draught, double psi);

/// In H, about the reference point, conjugate to surge to yaw; full waves, no build-up.
struct WaveForce {
  Vec6 first_order = Vec6::Zero();  ///< [N, N m]
  Vec6 drift = Vec6::Zero();        ///< Mean and slow variation, according to WaveDrift [N, N m].
  Vec6 mean_drift = Vec6::Zero();   ///< Mean over all phases [N, N m].
};

/// Returns the forces at time t [s] with the low-frequency position x, y [m] and heading psi [rad]. Does not allocate.
WaveForce wave_force(const HullWaves& waves, double t, const Vec3& slow);

/// Returns the mean drift only.
Vec6 mean_drift(const HullWaves& waves, double psi);

/// Returns the horizontal water velocity of the waves, averaged over the draught, at strips on the hull's centreline:
/// the first at `first` [m] forward of the reference point, `spacing` [m] apart. Does not allocate.
StripWater strip_water(const HullWaves& waves, double t, const Vec3& slow, double first, double spacing);

/// Returns the wave drift damping in H by Aranha (1994), deep water: B = sum a^2 ((4 w/g) D + (w^2/g) dD/dw) for a
/// velocity along each component's direction. [N s/m, N s]
Mat6 wave_drift_damping(const HydrodynamicData& data, const Sea& sea, double psi);

}  // namespace overbend
