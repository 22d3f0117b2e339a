/// A regular wave of finite height: Stokes' expansion of fifth order [fenton1985].
#pragma once

#include <array>

#include "base/vec.h"

namespace overbend {

/// Harmonics 1 to 5 are at indices 0 to 4. No mean Eulerian current.
struct StokesWave {
  double depth = 0.0;                 ///< [m]
  double omega = 0.0;                 ///< [rad/s]
  double wave_number = 0.0;           ///< [1/m]
  double kx = 0.0, ky = 0.0;          ///< Wave number in the direction of travel [1/m].
  double phase = 0.0;                 ///< [rad]
  std::array<double, 5> elevation{};  ///< Amplitudes of the surface [m].
  std::array<double, 5> speed{};      ///< Amplitudes of the horizontal velocity at still water level [m/s].
};

/// Makes a wave of `height` [m] and `period` [s] travelling in the direction (cos, sin) = (ex, ey) in W. Throws
/// std::domain_error if the theory has no such wave.
StokesWave stokes_wave(double height, double period, double depth, double ex, double ey, double phase);

/// Returns the surface elevation [m] over a point of W.
double elevation(const StokesWave& wave, double t, double x, double y);

struct WaveKinematics {
  Vec3 velocity = Vec3::Zero(), acceleration = Vec3::Zero();
  double pressure_head = 0.0;  ///< Head of the dynamic pressure, without the square of the velocity [m].
};
/// Returns velocity, its time derivative at a fixed point and the corresponding pressure; z must be between the seabed
/// and the surface, which is not checked.
WaveKinematics kinematics(const StokesWave& wave, double t, double x, double y, double z);

}  // namespace overbend
