/// Newton's method for equilibrium equations.
#pragma once

#include <optional>
#include <utility>

#include "statics/equations/static_system.h"

namespace overbend {

/// Step length control. `min_work`: to the point where the unbalanced forces do no further work along the step
/// (Crisfield 1991, section 9.2), which needs no potential and is valid for contact, friction and drag; damped where
/// the step leads uphill. `bounded_residual`: halved while the residual grows by more than a factor, undamped.
enum class StepSearch { min_work, bounded_residual };

struct NewtonSettings {
  double tolerance = 1e-9;  ///< Largest unbalanced nodal force over the force scale.
  int max_iterations = 60;
  std::optional<EquilibriumTarget> target = std::nullopt;  ///< If none, the far force is constant.
  double max_entering = 1e30;  ///< Maximum increase of the penetration of a roller in one step [m].
  bool has_plastic_memory =
      false;  ///< True if the tangent is inexact because of plastic strain from supports upstream.
  StepSearch search = StepSearch::min_work;
  double singular_damping = 1e2;  ///< Minimum damping if the tangent is singular [N/m2].
  double max_growth = 2.0;        ///< Maximum growth of the residual in a step, under `bounded_residual`.
  BodyStep body_step;
};

/// `slack`: the target needs a negative far force, that is compression in the line.
enum class NewtonEnd { converged, too_many_iterations, singular, lost, slack };

struct NewtonReport {
  NewtonEnd end = NewtonEnd::too_many_iterations;
  int iterations = 0;
  int trials = 0;  ///< Evaluations of the residual alone, in line searches.
  double residual = 0.0;
  int singular_node = -1;
  bool converged() const { return end == NewtonEnd::converged; }
};

/// Iterates `state` to equilibrium. Each step is limited in length and line-searched. The far force takes its whole
/// step before the search.
///
/// If a step leads uphill (past a limit point, where the pipe snaps through) or the search hardly moves, viscous
/// damping per length is added and the far force is kept, until steps lead downhill again; the damping then decreases.
NewtonReport solve_equilibrium(Equilibrium& equilibrium, SystemState& state, const NewtonSettings& settings);

/// Same for the pipe of a lay.
NewtonReport solve_equilibrium(StaticSystem& system, LineState& pipe, const NewtonSettings& settings);

}  // namespace overbend
