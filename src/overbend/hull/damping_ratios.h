/// Natural frequencies of a hull and the contributions to its damping in surge, sway and yaw, which limit its
/// low-frequency motions on its moorings.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "hull/hull.h"
#include "model/description/hydrodynamic_data.h"

namespace overbend {

/// Returns the added mass of the file at a frequency [rad/s], linearly interpolated, constant beyond.
Mat6 added_mass_at(const HydrodynamicData& data, double omega);

/// Returns the natural frequency of a single mode, w^2 (m + A(w)) = c [rad/s].
double natural_frequency(const HydrodynamicData& data, int mode, double mass, double stiffness);

/// Returns 2 c / w with that frequency. [N s/m, N m s]
double critical_damping(const HydrodynamicData& data, int mode, double mass, double stiffness);

/// Least damped oscillation of a mode.
struct DampedOscillation {
  double period = 0.0;   ///< [s]
  double damping = 0.0;  ///< Share of critical damping; negative: unstable.
};

/// One mode with a spring and a damper on the low-frequency motion: m s^2 + b s + k + F (k' + c' s) = 0 with the filter
/// F = w^2/(s + w)^2. `mass`: with added mass [kg, kg m^2].
struct SlowLoop {
  double mass = 0.0, damping = 0.0, stiffness = 0.0;
  double slow_damping = 0.0, slow_stiffness = 0.0;  ///< Acting on the low-frequency motion.
  double low_frequency_period = 0.0;                ///< Corner period of the filter [s].
};
/// Returns the least damped oscillation of the loop.
DampedOscillation find_least_damped(const SlowLoop& loop);

/// Contributions to the damping of one mode, as shares of critical.
struct ModeDamping {
  std::string mode;       ///< surge, sway, yaw.
  double period = 0.0;    ///< Natural period of the single mode [s].
  double critical = 0.0;  ///< [N s/m, N m s]
  double radiation = 0.0, drift = 0.0, current = 0.0, viscous = 0.0;
  /// Share of dynamic positioning, which lags with the filter: may be negative.
  double station_keeping = 0.0;
  /// With dynamic positioning: a lagging spring and damper shift the period, and the shares above, at the natural
  /// period, do not show whether the loop is stable.
  std::optional<DampedOscillation> loop{};

  double total() const { return radiation + drift + current + viscous + station_keeping; }
};

/// Returns the damping of the hull at its nominal heading with this restoring stiffness (only its diagonal; of the
/// moorings about the reference point, horizontal axes along the nominal heading). The current's part is for small
/// motions about the steady flow. Drag of the lines is not included.
std::array<ModeDamping, 3> horizontal_damping(const Hull& hull, const HydrodynamicData& data,
                                              const Mat6& station_stiffness);

}  // namespace overbend
