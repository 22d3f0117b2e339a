/// Moment in a hinge: stops on either side, and friction.
///
/// A stop is a spring with a dashpot that never pulls. Friction is Coulomb's with an elastic part, as that of rollers
/// (mechanics/contact_law.h): before the hinge turns it yields by kBreakaway.
#pragma once

#include <limits>

#include "mechanics/contact_law.h"

namespace overbend {

/// How far a hinge yields before its friction is overcome [rad].
inline constexpr double kBreakaway = 2e-4;
/// Damping of a stop, of critical with the inertia of what it stops: it rebounds with some 85 % of its speed.
inline constexpr double kStopDamping = 0.05;

struct HingeLaw {
  double up = -std::numeric_limits<double>::infinity();   ///< Angle at which the upper stop begins to carry [rad].
  double down = std::numeric_limits<double>::infinity();  ///< Likewise of the lower one [rad].
  double stop_stiffness = 0.0;                            ///< [N m/rad]
  double stop_damping = 0.0;                              ///< [N m s/rad]
  double friction = 0.0;                                  ///< Moment before it turns [N m].
  double friction_damping = 0.0;                          ///< Of the elastic part [N m s/rad].
};

/// Moments on the body, positive when they push the tip down [N m], with what follows from them.
struct HingeMoment {
  double stop = 0.0, friction = 0.0;
  double by_angle = 0.0;  ///< Of the sum [N m/rad].
  double by_rate = 0.0;   ///< [N m s/rad]
  double slip = 0.0;      ///< Elastic part of the friction at the end of the step [rad].
  double stored = 0.0;    ///< In the stop's spring [J].

  double sum() const { return stop + friction; }
};

/// What the springs of the stops exert at an angle, without their dashpots [N m].
double stop_spring_moment(const HingeLaw& law, double angle);

/// At an angle [rad] with its rate [rad/s], a step of `dt` [s] after the friction's elastic part was `slip`.
HingeMoment hinge_moment(const HingeLaw& law, double angle, double rate, double slip, double dt);

}  // namespace overbend
