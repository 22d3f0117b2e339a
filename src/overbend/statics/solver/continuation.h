/// Continuation methods from an initial shape to the equilibrium of one problem on one mesh.
#pragma once

#include <string>

#include "results/static_results.h"
#include "statics/equations/static_system.h"
#include "statics/initial_shape/lay_shape.h"

namespace overbend {

/// Equilibrium problem on one mesh during its solution.
struct EquilibriumProblem {
  const Model& model;
  StaticSystem system;
  LineState state;
  EquilibriumTarget target;
  SolveReport report;
  double work = 0.0;  ///< Computational effort so far: Newton steps times `size()`, and other evaluations in the
                      ///< same unit.
  double tension_at_compression =
      0.0;  ///< Top tension at which an attempt ended without tension at the seabed, otherwise 0 [N].

  /// Message naming the first roller box (from the tensioner) that the pipe missed in a failed attempt; empty if none.
  std::string missed_box_message = {};
  /// Place of the maximum bending of linear-elastic pipe, if an equilibrium exists only for linear steel; otherwise
  /// empty.
  std::string yield_message = {};

  /// Cost of one Newton step, in elements; includes the rollers, each of which searches along the whole line.
  double size() const;
  /// Maximum effort per problem. Counted, not timed: every machine gives the same answer.
  double max_work() const;
  /// True if the effort is used up; no further load step is then started.
  bool is_exhausted() const { return work >= max_work(); }
};

/// Tries one continuation method after another from the initial shape, with linear steel; the report names the one that
/// converged.
bool solve_elastic(EquilibriumProblem& problem, const LayShape& shape);

/// Makes the steel linear until activate_plasticity().
void make_elastic(EquilibriumProblem& problem);

/// Continues from the elastic shape to yielding steel: at once, or with the plastic moments in steps.
bool activate_plasticity(EquilibriumProblem& problem);

/// Solves from a neighbouring solution in one step.
bool solve_from_warm_start(EquilibriumProblem& problem, const char* stage);

/// Solves from a neighbouring shape with rollers and bed softened, then hardened in steps (penalty continuation).
bool solve_with_penalty_continuation(EquilibriumProblem& problem);

}  // namespace overbend
