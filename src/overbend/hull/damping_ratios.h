/// Natural frequencies of a hull and its damping in surge, sway and yaw, part by part: what decides how far it swings
/// slowly on its moorings.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "hull/hull.h"
#include "model/description/hydrodynamic_data.h"

namespace overbend {

/// Added mass of the file at a frequency [rad/s], linear in between, held beyond.
Mat6 added_mass_at(const HydrodynamicData& data, double omega);

/// Natural frequency of one mode alone, w^2 (m + A(w)) = c [rad/s].
double natural_frequency(const HydrodynamicData& data, int mode, double mass, double stiffness);

/// 2 c / w with that frequency. [N s/m, N m s]
double critical_damping(const HydrodynamicData& data, int mode, double mass, double stiffness);

/// The swing of one mode that is damped least.
struct LeastDamped {
  double period = 0.0;   ///< [s]
  double damping = 0.0;  ///< Share of critical; negative: it grows by itself.
};

/// One mode with a spring and a damper that act on the slow motion: m s^2 + b s + k + F (k' + c' s) = 0 with the filter
/// F = w^2/(s + w)^2. `mass`: with added mass [kg, kg m^2].
struct SlowLoop {
  double mass = 0.0, damping = 0.0, stiffness = 0.0;
  double slow_damping = 0.0, slow_stiffness = 0.0;  ///< Of what acts on the slow motion.
  double slow_period = 0.0;                         ///< Of the filter's corner [s].
};
LeastDamped least_damped(const SlowLoop& loop);

/// Shares of critical damping of one mode.
struct ModeDamping {
  std::string mode;       ///< surge, sway, yaw.
  double period = 0.0;    ///< Natural, of the mode alone [s].
  double critical = 0.0;  ///< [N s/m, N m s]
  double radiation = 0.0, drift = 0.0, current = 0.0, viscous = 0.0;
  /// Of dynamic positioning, whose slow motion lags: may be negative.
  double station_keeping = 0.0;
  /// With dynamic positioning: a spring and a damper that lag shift the period, and the shares above, which are of the
  /// natural period, do not tell whether the loop is stable.
  std::optional<LeastDamped> loop{};

  double total() const { return radiation + drift + current + viscous + station_keeping; }
};

/// Of the hull at its drawn heading, kept by springs of this stiffness (diagonal used; of the moorings about the
/// reference point, horizontal axes along the drawn hull). The current's part is that of small motions about the
/// steady flow. Lines add their own drag, which is not in here.
std::array<ModeDamping, 3> horizontal_damping(const Hull& hull, const HydrodynamicData& data,
                                              const Mat6& station_stiffness);

}  // namespace overbend
