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

namespace overbend {

/// Elevation: amplitude cos(kx x + ky y - omega t + phase).
struct WaveComponent {
  double amplitude = 0.0;     ///< [m]
  double omega = 0.0;         ///< [rad/s]
  double wave_number = 0.0;   ///< [1/m]
  double kx = 0.0, ky = 0.0;  ///< Wave number towards the direction of travel [1/m].
  double phase = 0.0;         ///< [rad]
};

/// Made by make_sea; the components are there to be read, not changed.
struct Sea {
  WaveType type = WaveType::none;
  double depth = 0.0;                     ///< Still water depth used by the waves [m].
  std::vector<WaveComponent> components;  ///< By rising wave number; of a Stokes wave its first harmonic alone.
  StokesWave stokes;                      ///< For stokes5.
  AlignedDoubles table;                   ///< Components and their constants as the kernel reads them.

  bool calm() const { return components.empty(); }
};

/// The sea of a description. The same seed gives the same sea, however long it is simulated. Throws
/// std::invalid_argument for a sea without spectrum or size, std::domain_error for a Stokes wave that does not exist.
Sea make_sea(const WavesDescription& waves, double depth, std::uint64_t seed);

/// A sea of given linear waves; wave numbers are found from the frequencies, kx and ky turned to their length. The
/// components are sorted.
Sea make_sea(std::vector<WaveComponent> components, double depth);

/// How like itself the record of a random sea is at a later time within the simulated time [s], 0 to 1: the largest
/// autocorrelation of the components beyond 30 mean periods. 1 would be a repetition.
double recurrence(const Sea& sea, double simulated_time);

struct WaterState {
  Vec3 velocity = Vec3::Zero();      ///< [m/s]
  Vec3 acceleration = Vec3::Zero();  ///< Time derivative of the velocity at the point [m/s2].
  double elevation = 0.0;            ///< Of the surface over the point [m].
  /// Dynamic pressure over the water's weight density: the pressure is that weight density times (head - z) [m]. Phase
  /// speed times horizontal velocity over gravity, which balances the acceleration above: rho a = -grad p.
  double pressure_head = 0.0;
};

/// Motion of the water at points of W at time t [s]. Elevation and velocity carry the build-up's value, the
/// acceleration its rate times the velocity besides. Points above the surface get what the water has at the surface
/// below them, points under the bed what it has at the bed. Does not allocate; safe from several threads.
void water_state(const Sea& sea, double t, const BuildUp& build_up, std::span<const Vec3> points,
                 std::span<WaterState> out);

/// Surface elevation [m] over a point of W.
double elevation(const Sea& sea, double t, const BuildUp& build_up, double x, double y);

/// One-sided spectral density S(omega) [m2 s] of a described sea, 0 for regular waves. Builds the spectrum each time;
/// for many frequencies use WaveSpectrum.
double spectral_density(const WavesDescription& waves, double omega);

/// Highest frequency with which the water moves [rad/s]; 0 when calm.
double highest_frequency(const Sea& sea);

}  // namespace overbend
