/// Moment in a hinge: end stops and friction.
///
/// A stop is a spring with a dashpot that never pulls. Friction is Coulomb friction with an elastic part, as for
/// rollers (mechanics/contact_law.h): the hinge deforms elastically by kBreakawayRotation before it slips.
#pragma once

#include <limits>

#include "mechanics/contact_law.h"

namespace overbend {

/// Elastic rotation of a hinge before its friction is overcome [rad].
inline constexpr double kBreakawayRotation = 2e-4;
/// Damping ratio of a stop with the inertia of the stopped body: the rebound has about 85 % of the impact speed [-].
inline constexpr double kStopDamping = 0.05;

struct HingeLaw {
  double up = -std::numeric_limits<double>::infinity();   ///< Angle at which the upper stop engages [rad].
  double down = std::numeric_limits<double>::infinity();  ///< Angle at which the lower stop engages [rad].
  double stop_stiffness = 0.0;                            ///< [N m/rad]
  double stop_damping = 0.0;                              ///< [N m s/rad]
  double friction = 0.0;                                  ///< Breakaway moment [N m].
  double friction_damping = 0.0;                          ///< Damping of the elastic part [N m s/rad].
};

/// Moments on the body with their derivatives; positive when they push the tip down [N m].
struct HingeMoment {
  double stop = 0.0, friction = 0.0;
  double by_angle = 0.0;  ///< Derivative of the sum [N m/rad].
  double by_rate = 0.0;   ///< [N m s/rad]
  double slip = 0.0;      ///< Elastic part of the friction at the end of the step [rad].
  double stored = 0.0;    ///< Energy in the stop's spring [J].

  double sum() const { return stop + friction; }
};

/// Returns the spring moment of the stops at an angle, without their dashpots [N m].
double stop_spring_moment(const HingeLaw& law, double angle);

/// Returns the moment at an angle [rad] and rate [rad/s], a step of `dt` [s] after the elastic part of the friction was
/// `slip` [rad].
HingeMoment hinge_moment(const HingeLaw& law, double angle, double rate, double slip, double dt);

}  // namespace overbend
