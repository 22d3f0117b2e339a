/// Coupled equilibrium of lines and free bodies.
#pragma once

#include "statics/equations/equilibrium.h"

namespace overbend {

struct CoupledSolveSettings {
  double tolerance = 1e-8;   ///< Largest unbalanced force over the force scale, for lines and bodies.
  int max_iterations = 100;  ///< Iterations of the coupled Newton's method.
  int max_rounds = 40;       ///< Rounds of the fallback: lines on fixed bodies, then bodies by half a step.
  BodyStep body_step;        ///< Small, as rollers are stiff.
};

struct CoupledSolveReport {
  bool converged = false;
  int iterations = 0;
  int rounds = 0;                         ///< Rounds of the fallback; 0 if Newton's method converged.
  double residual = 0.0;                  ///< Largest unbalanced force over the force scale in the returned state.
  std::pair<int, int> worst_place{0, 0};  ///< Location of the residual, as from Assembly::worst_place().
};

/// Finds the coupled equilibrium of lines and free bodies of `state`, with the surroundings at its time: first the
/// lines with fixed bodies, from shapes that should be near their equilibrium, then all. Bed friction depends on the
/// displacement, as in a step without inertia; roller friction is System::rub, as in the statics of the pipe.
/// Ends moved by a tensioner must be released before by Assembly::set_drive(governor). Freedoms held by
/// Assembly::hold_body() stay held.
///
/// Newton's method with bounded steps of the bodies. If it does not converge, block Gauss-Seidel: lines with fixed
/// bodies, then bodies by half the step of the reduced system, repeatedly. Rates of `state` are zero afterwards.
CoupledSolveReport solve_coupled_equilibrium(Assembly& assembly, SystemState& state,
                                             const CoupledSolveSettings& settings = {});

/// Gives the contacts of an equilibrium state the slip at which they carry the friction of System::rub, so that a
/// simulation starts from the static equilibrium. Ends and surroundings are those set last.
void mobilise_roller_friction(Assembly& assembly, SystemState& state);

}  // namespace overbend
