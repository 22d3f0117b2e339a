/// Weights that unify the equations of statics and dynamics.
#pragma once

namespace overbend {

/// Weights of damping and mass in the tangent, relative to the stiffness: derivatives of velocities and accelerations
/// by the unknowns in the integrator. Zero for a line at rest.
struct Weights {
  double velocity = 0.0;      ///< Weight of the damping [1/s].
  double acceleration = 0.0;  ///< Weight of the mass [1/s2].
  double step = 0.0;          ///< Time since the start of the step [s].
};

}  // namespace overbend
