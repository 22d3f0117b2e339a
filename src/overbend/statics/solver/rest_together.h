/// Equilibrium of lines and free bodies together.
#pragma once

#include "statics/equations/equilibrium.h"

namespace overbend {

struct RestSettings {
  double tolerance = 1e-8;   ///< Largest unbalanced force over the force scale, of lines and bodies.
  int max_iterations = 100;  ///< Of Newton's method for all together.
  int max_rounds = 40;       ///< Of the fallback: lines on held bodies, then the bodies by half a step.
  BodyStep body_step;        ///< Short: rollers are stiff.
};

struct RestReport {
  bool converged = false;
  int iterations = 0;
  int rounds = 0;                         ///< Of the fallback; 0 where Newton's method went through.
  double residual = 0.0;                  ///< Largest unbalanced force over the force scale, of the state returned.
  std::pair<int, int> worst_place{0, 0};  ///< Where it is, as Assembly::worst_place() has it.
};

/// Brings lines and free bodies of `state` to rest together, with the surroundings as they are at its time: first the
/// lines on the bodies where they are, from shapes that should be near their equilibrium there, then all. The
/// bed's friction goes with the way, as in a step without inertia; that of rollers is System::rub, as in the pipe's own
/// statics.
/// Ends that a tensioner moves are let go by Assembly::set_drive(governor) before. Freedoms held by
/// Assembly::hold_body() stay.
///
/// Newton's method with bounded moves of the bodies; where it does not settle, block Gauss-Seidel: lines on held
/// bodies, bodies by half the step that the reduced system asks for, again and again. Rates of `state` are zero
/// afterwards.
RestReport rest_together(Assembly& assembly, SystemState& state, const RestSettings& settings = {});

/// Gives the contacts of a state at rest the slip at which they bear the friction of System::rub, so that a run starts
/// from the equilibrium of statics. Ends and surroundings are those set last.
void mobilise_roller_friction(Assembly& assembly, SystemState& state);

}  // namespace overbend
