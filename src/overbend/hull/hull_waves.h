/// First-order wave forces and drift of the hull from the components of the sea: the same components, and so the same
/// sea, that the lines feel.
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
  int count = 0;                                ///< Components with padding.
  AlignedDoubles components;                    ///< omega, kx, ky, phase, direction, orbital speed; one column each.
  AlignedDoubles table;                         ///< [component][heading][force re, im, drift] of eight doubles each.
  std::vector<double> heading;                  ///< Rising [rad].
  bool all_around = false;                      ///< The headings close a circle.
  double below_table = 0.0, above_table = 0.0;  ///< Share of the sea's variance beyond the force's frequencies [-].
  double above_drift = 0.0;                     ///< Likewise above those of the drift, whose waves do not drift [-].

  bool empty() const { return count == 0; }
};

/// Tables of the excitation and the drift on the components of a sea. Interpolated linearly in frequency, real and
/// imaginary parts apart; below the file's frequencies its first value, above none. `draught` [m] averages the
/// water's velocity. Throws std::invalid_argument when the headings of the file, seen from the hull with heading
/// `psi` [rad], do not reach a component's.
HullWaves make_hull_waves(const HydrodynamicData& data, const Sea& sea, WaveDrift drift, double draught, double psi);

/// In H, about the reference point, conjugate to surge to yaw; full waves, no build-up.
struct WaveForce {
  Vec6 first_order = Vec6::Zero();  ///< [N, N m]
  Vec6 drift = Vec6::Zero();        ///< Mean and slow variation, by WaveDrift [N, N m].
  Vec6 mean_drift = Vec6::Zero();   ///< Its mean over all phases [N, N m].
};

/// At time t [s], hull slowly at x, y [m] with heading psi [rad]. Does not allocate.
WaveForce wave_force(const HullWaves& waves, double t, const Vec3& slow);

/// The mean drift alone.
Vec6 mean_drift(const HullWaves& waves, double psi);

/// Horizontal velocity of the water under the waves, averaged over the draught, at strips on the hull's centreline:
/// the first at `first` [m] forward of the reference point, `spacing` [m] apart. Does not allocate.
StripWater strip_water(const HullWaves& waves, double t, const Vec3& slow, double first, double spacing);

/// Wave drift damping in H by Aranha (1994), deep water: B = sum a^2 ((4 w/g) D + (w^2/g) dD/dw) for a velocity along
/// each component's travel. [N s/m, N s]
Mat6 wave_drift_damping(const HydrodynamicData& data, const Sea& sea, double psi);

}  // namespace overbend
