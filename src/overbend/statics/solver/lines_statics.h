/// Equilibrium of lines between held ends: mooring lines, and lines without a lay. Lines that share no unknowns are
/// solved one by one.
#pragma once

#include "statics/solver/newton.h"
#include "system/assembly.h"

namespace overbend {

struct LineSolveSettings {
  double tolerance = 1e-9;  ///< Largest unbalanced nodal force over the line's force scale.
  int max_iterations = 2000;
};

/// Iterates the shape of one line of an assembly, whose held ends are in place, to equilibrium: Newton's method as for
/// the pipe, with line search and damping where a step leads uphill, and continuation in axial stiffness if that fails.
/// A slack cable has almost no lateral stiffness and needs many iterations, of microseconds each. Bed friction acts
/// from the shape in `laid`, as in a step of `pseudo_time_step` seconds without inertia or waves; velocities of the
/// line are those of that step.
NewtonReport solve_line_equilibrium(Assembly& assembly, std::size_t line, const SystemState& laid,
                                    double pseudo_time_step, SystemState& state,
                                    const LineSolveSettings& settings = {});

/// Effect of rounding of positions on the nodal forces of a line, over its force scale: its elements are stiff.
double rounding_residual(const Line& line, const std::vector<double>& q);

struct LinesEquilibriumReport {
  std::vector<NewtonReport> lines;  ///< Reports in the order of the system.
  /// True for lines held by friction in the bows of their initial shapes; these have no equilibrium on a straight
  /// course with friction.
  std::vector<bool> lies_in_bow;
  bool converged() const;
};

/// Finds the equilibrium of every line of `state` from its initial shape, with the surroundings at its time and without
/// waves. Velocities and memories of `state` are unchanged except for the displacement of bed friction, which follows
/// the shapes. The assembly is left evaluated there, so that end forces and section forces can be read.
LinesEquilibriumReport solve_lines_one_by_one(Assembly& assembly, SystemState& state,
                                              const LineSolveSettings& settings = {});

}  // namespace overbend
