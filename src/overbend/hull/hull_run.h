/// A hull alone in time, with or without linear springs: its responses, decay tests and one-way analyses.
#pragma once

#include "hull/hull.h"
#include "numerics/generalized_alpha.h"

namespace overbend {

/// Springs to a pose: generalised force -stiffness (h - rest), and dampers -damping v, axes of W.
struct HullSprings {
  Mat6 stiffness = Mat6::Zero();  ///< [N/m, N, N m]
  Mat6 damping = Mat6::Zero();    ///< [N s/m, N s, N m s]
  Vec6 rest = Vec6::Zero();
};

/// Sets the true and the algorithmic acceleration of a state from its forces at `time` [s]; its memories are not
/// changed.
void find_hull_acceleration(const Hull& hull, const HullSprings& springs, double time, HullState& state);

/// Convergence of a step.
struct HullStepResult {
  bool converged = false;
  int iterations = 0;
};

/// Takes one step of the generalized-alpha method to `time` [s], in place. Newton's method until the residual is below
/// 1e-10 of the inertia forces or at rounding; not converged after 12 iterations: the state is not changed. Does not
/// allocate once `scratch` has been used.
HullStepResult hull_step(const Hull& hull, const HullSprings& springs, const GeneralizedAlpha& scheme, double time,
                         double step, HullState& state, HullState& scratch);

/// Takes steps of equal length from `start` [s] to `start + steps * step` and calls `look(time, state)` after each.
/// Returns true if every step converged.
template <class Look>
bool run_hull(const Hull& hull, const HullSprings& springs, double spectral_radius, double start, double step,
              int steps, HullState& state, Look&& look) {
  const GeneralizedAlpha scheme(spectral_radius);
  HullState scratch = state;
  for (int i = 1; i <= steps; ++i) {
    const double time = start + i * step;
    if (!hull_step(hull, springs, scheme, time, step, state, scratch).converged) return false;
    look(time, static_cast<const HullState&>(state));
  }
  return true;
}

}  // namespace overbend
