/// Newton's method on the equations of rest.
#pragma once

#include <optional>
#include <utility>

#include "statics/equations/static_system.h"

namespace overbend {

/// How far a step is taken. `least_work`: to where the unbalanced forces do no more work along it (Crisfield 1991,
/// section 9.2), which needs no potential and so serves contact, friction and drag alike; damped where it leads uphill.
/// `bounded_residual`: halved while the residual grows by more than a factor, undamped.
enum class StepSearch { least_work, bounded_residual };

struct NewtonSettings {
  double tolerance = 1e-9;  ///< Largest unbalanced nodal force over the force scale.
  int max_iterations = 60;
  std::optional<EquilibriumTarget> target = std::nullopt;  ///< None: the far force stays.
  double entering = 1e30;  ///< No step drives a line deeper than this into a roller beyond where it is [m].
  bool remembers = false;  ///< The tangent is not exact: steel remembers what happened upstream.
  StepSearch search = StepSearch::least_work;
  double singular_damping = 1e2;  ///< At least so much where the tangent is singular [N/m2].
  double max_growth = 2.0;        ///< Of the residual in a step, under `bounded_residual`.
  BodyStep body_step;
};

/// `slack`: the target needs a far force below zero, the line would lie in compression.
enum class NewtonEnd { converged, too_many_iterations, singular, lost, slack };

struct NewtonReport {
  NewtonEnd end = NewtonEnd::too_many_iterations;
  int iterations = 0;
  int trials = 0;  ///< Looks at the residual alone, in searches along steps.
  double residual = 0.0;
  int singular_node = -1;
  bool converged() const { return end == NewtonEnd::converged; }
};

/// Iterates `state` towards equilibrium. Each step is limited in length and searched along. The far force takes its
/// whole step before the search.
///
/// Where a step leads uphill (past a limit point: the pipe is about to snap to another place) or the search hardly
/// moves, a viscous resistance per length is added to the step and the far force stays, until steps lead downhill
/// again; it fades as they work.
NewtonReport solve_equilibrium(Equilibrium& equilibrium, SystemState& state, const NewtonSettings& settings);

/// Of a lay's pipe.
NewtonReport solve_equilibrium(StaticSystem& system, LineState& pipe, const NewtonSettings& settings);

}  // namespace overbend
