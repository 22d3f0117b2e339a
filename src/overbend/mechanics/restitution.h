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

/// Largest damping ratio that `damping_ratio` answers. A perfectly plastic impact would take an infinite one; at this
/// the mass keeps 0.24 % of its speed, 6e-6 of its energy.
inline constexpr double kLargestDampingRatio = 10.0;

/// Coefficient of restitution of a linear spring-dashpot that never pulls, for any damping ratio >= 0 [-].
double restitution_of(double damping_ratio);

/// Share of critical damping that gives the coefficient of restitution: `clipped` inverts `restitution_of`, `textbook`
/// is -ln e / sqrt(pi^2 + ln^2 e). 1 and more needs no damping. In clipped form the answer is at most
/// kLargestDampingRatio, in textbook form at most 1.
double damping_ratio(double restitution, RestitutionForm form);

}  // namespace overbend
