/// A hull alone in time, on linear springs or none: the hull's own responses, decays and one-way analyses.
#pragma once

#include "hull/hull.h"
#include "numerics/generalized_alpha.h"

namespace overbend {

/// Springs to a pose: generalised force -stiffness (h - rest) and dampers -damping v, axes of W.
struct HullSprings {
  Mat6 stiffness = Mat6::Zero();  ///< [N/m, N, N m]
  Mat6 damping = Mat6::Zero();    ///< [N s/m, N s, N m s]
  Vec6 rest = Vec6::Zero();
};

/// Sets the true and the algorithmic acceleration of a state to that of its forces at `time` [s]; the memories of the
/// state are as they are.
void find_hull_acceleration(const Hull& hull, const HullSprings& springs, double time, HullState& state);

struct HullStepResult {
  bool converged = false;
  int iterations = 0;
};

/// One step of the generalized-alpha method to `time` [s], in place. Newton's method until the residual is below 1e-10
/// of the inertia forces or stands at rounding; not converged after 12 iterations: the state is left as it was. Does
/// not allocate once `scratch` has been used.
HullStepResult hull_step(const Hull& hull, const HullSprings& springs, const GeneralizedAlpha& scheme, double time,
                         double step, HullState& state, HullState& scratch);

/// Steps of one length from `start` [s] to `start + steps * step`; `look(time, state)` after each. Returns whether
/// every step converged.
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
