/// The sea: surface elevation and motion of the water under waves, from regular to random.
///
/// Frame W: x east, y north, z up from the mean water level. Theory: docs/theory/waves.md.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/aligned.h"
#include "base/simd.h"
#include "base/vec.h"
#include "mechanics/build_up.h"
#include "mechanics/stokes_wave.h"
#include "mechanics/wave_kernel.h"
#include "mechanics/wave_spectrum.h"
#include "model/description/waves_description.h"
#include "model/site/wave_groups.h"

namespace overbend {

/// Elevation: amplitude cos(kx x + ky y - omega t + phase).
struct WaveComponent {
  double amplitude = 0.0;     ///< [m]
  double omega = 0.0;         ///< [rad/s]
  double wave_number = 0.0;   ///< [1/m]
  double kx = 0.0, ky = 0.0;  ///< Wave number towards the direction of travel [1/m].
  double phase = 0.0;         ///< [rad]
};

/// Made by make_sea; the components are read-only.
struct Sea {
  bool nonlinear = false;                 ///< A Stokes wave, alone; all others are sums of linear waves.
  double depth = 0.0;                     ///< Still-water depth used by the waves [m].
  std::vector<WaveComponent> components;  ///< Sorted by rising wave number; for a Stokes wave only its first harmonic.
  StokesWave stokes;                      ///< For stokes5.
  AlignedDoubles table;                   ///< Components and their constants in the layout of the kernel.

  bool calm() const { return components.empty(); }
};

/// Makes the sea of all groups of waves together, which superpose linearly, in a water depth [m]. The same seed gives
/// the same sea, regardless of the simulated time; the seed of each group is that of group_seed(). Throws
/// std::invalid_argument for a group without spectrum or size, or a Stokes wave among others, std::domain_error for a
/// Stokes wave that does not exist.
Sea make_sea(const WaveGroups& groups, double depth, std::uint64_t seed);

/// The same for one group.
Sea make_sea(const WavesDescription& waves, double depth, std::uint64_t seed);

/// Makes a sea of given linear waves; wave numbers follow from the frequencies, kx and ky are scaled to them. The
/// components are sorted.
Sea make_sea(std::vector<WaveComponent> components, double depth);

/// Returns the similarity of a random sea's record with itself at a later time within the simulated time [s], 0 to 1:
/// the maximum autocorrelation of the components beyond 30 mean periods. 1 would be a repetition.
double recurrence(const Sea& sea, double simulated_time);

struct WaterState {
  Vec3 velocity = Vec3::Zero();      ///< [m/s]
  Vec3 acceleration = Vec3::Zero();  ///< Time derivative of the velocity at the point [m/s2].
  double elevation = 0.0;            ///< Elevation of the surface over the point [m].
  /// Dynamic pressure over the water's weight density: the pressure is that weight density times (head - z) [m]. Phase
  /// speed times horizontal velocity over gravity, which balances the acceleration above: rho a = -grad p.
  double pressure_head = 0.0;
};

/// Computes the motion of the water at points of W at time t [s]. Elevation and velocity are scaled by the build-up's
/// value; the acceleration also contains its rate times the velocity. Points above the surface get the values at the
/// surface below them, points below the seabed the values at the seabed. Does not allocate; thread-safe.
void water_state(const Sea& sea, double t, const BuildUp& build_up, std::span<const Vec3> points,
                 std::span<WaterState> out);

/// Returns the surface elevation [m] over a point of W.
double elevation(const Sea& sea, double t, const BuildUp& build_up, double x, double y);

/// Returns the one-sided spectral density S(omega) [m2 s] of a described sea, 0 for regular waves and measured
/// elevations. Builds the spectrum each time; use WaveSpectrum for many frequencies.
double spectral_density(const WavesDescription& waves, double omega);

/// Returns the highest frequency of the water motion [rad/s]; 0 when calm.
double highest_frequency(const Sea& sea);

}  // namespace overbend
