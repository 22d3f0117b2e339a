/// Damping of a contact from its coefficient of restitution, after [schwager2007].
///
/// A mass m meets a linear spring k and dashpot c = 2 zeta sqrt(k m) with speed v and leaves with e v:
///
///     force     .-.            the dashpot would pull the mass back at the end of the rebound; rollers release
///              /   \           instead, earlier and with the spring still compressed
///     --------'     '. clipped
///                     '-._.-'  textbook
#pragma once

namespace overbend {

enum class RestitutionForm {
  clipped,   ///< The contact never pulls: it ends where the force passes zero.
  textbook,  ///< The contact ends where the penetration passes zero, after half a damped period.
};

/// Upper limit of the damping ratio returned by `damping_ratio`. A perfectly plastic impact would need an infinite one;
/// at this limit the mass keeps 0.24 % of its speed, 6e-6 of its energy.
inline constexpr double kMaxDampingRatio = 10.0;

/// Returns the coefficient of restitution of a linear spring-dashpot that never pulls, for any damping ratio >= 0 [-].
double compute_restitution(double damping_ratio);

/// Returns the damping ratio for a coefficient of restitution: `clipped` inverts `compute_restitution`, `textbook` is
/// -ln e / sqrt(pi^2 + ln^2 e). Restitution of 1 or more needs no damping. The result is at most kMaxDampingRatio in
/// clipped form and at most 1 in textbook form.
double damping_ratio(double restitution, RestitutionForm form);

}  // namespace overbend
