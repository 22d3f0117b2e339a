/// What makes one equation of statics and dynamics.
#pragma once

namespace overbend {

/// How much of damping and mass stands in the tangent beside the stiffness, whose weight is 1: by how much velocities
/// and accelerations change with the unknowns, by the integrator's formulas. A line at rest has neither.
struct Weights {
  double velocity = 0.0;      ///< Weight of the damping [1/s].
  double acceleration = 0.0;  ///< Weight of the mass [1/s2].
  double step = 0.0;          ///< Time since the memories were what they are before the step [s].
};

}  // namespace overbend
