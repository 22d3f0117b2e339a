/// Newton's method with line search on a StaticSystem.
#pragma once

#include <string>

#include "statics/equations/static_system.h"

namespace overbend {

struct NewtonSettings {
  double tolerance = 1e-9;  ///< Largest unbalanced nodal force over the total weight.
  int max_iterations = 60;
  bool free_far_force = true;  ///< False: H stays, the extra equation is not looked at.
  double entering = 1e30;      ///< No step drives the pipe deeper than this into a roller beyond where it is [m].
  bool remembers = false;      ///< The tangent is not exact: steel remembers what happened upstream.
};

/// `slack`: what is wanted needs a far force below zero, the line would lie in compression.
enum class NewtonEnd { converged, too_many_iterations, singular, lost, slack };

struct NewtonReport {
  NewtonEnd end = NewtonEnd::too_many_iterations;
  int iterations = 0;
  int trials = 0;  ///< Looks at the residual alone, in searches along steps.
  double residual = 0.0;
  int singular_node = -1;
  bool converged() const { return end == NewtonEnd::converged; }
};

/// What the state lacks of what is wanted: of a tension, over it or the total weight, whichever is less; of the
/// anchor's distance, over the total length.
double relative_target_error(const StaticSystem& system, const LineState& state, const LineTargetValue& target);

/// Iterates `state` towards equilibrium. Each step is limited in length and searched along for the point where the
/// unbalanced forces do no more work (Crisfield 1991, section 9.2), which needs no potential and so serves contact,
/// friction and drag alike. The far force takes its whole step before the search.
///
/// Where a step leads uphill (past a limit point: the pipe is about to snap to another place) or the search hardly
/// moves, a viscous resistance per length is added to the step and H stays, until steps lead downhill again; it fades
/// as they work.
NewtonReport newton(StaticSystem& system, LineState& state, const LineTargetValue& target,
                    const NewtonSettings& settings);

}  // namespace overbend
