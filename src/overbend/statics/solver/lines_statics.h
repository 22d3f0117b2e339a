/// Equilibrium of lines between held ends: mooring lines, and lines that stand by themselves. Lines that share no
/// unknowns rest each by itself.
#pragma once

#include "statics/solver/newton.h"
#include "system/assembly.h"

namespace overbend {

struct LineRestSettings {
  double tolerance = 1e-9;  ///< Largest unbalanced nodal force over the line's force scale.
  int max_iterations = 2000;
};

/// Iterates the shape of one line of an assembly, whose held ends are in their places, towards equilibrium: Newton's
/// method as for the pipe, searched along and damped where a step leads uphill; where that does not find it, from soft
/// to hard. A slack cable has next to no stiffness across, and its way down is long: hence the many iterations it may
/// take; they cost microseconds. The bed's friction holds from the shape in `laid` on, as in a step of `slowly` seconds
/// without inertia and without waves; velocities of the line are those of that step.
NewtonReport rest_line(Assembly& assembly, std::size_t line, const SystemState& laid, double slowly, SystemState& state,
                       const LineRestSettings& settings = {});

/// What rounding of the places makes of the forces on a node of a line, over its force scale: its elements are stiff.
double rounding_residual(const Line& line, const std::vector<double>& q);

struct LinesRest {
  std::vector<NewtonReport> lines;  ///< In the order of the system.
  /// Lines that rest where their first guess laid them, in bows, held there by friction: on a straight course, where
  /// friction holds the others, they have no room.
  std::vector<bool> in_bows;
  bool converged() const;
};

/// Brings every line of `state`, whose shapes are first guesses, to rest with the surroundings as they are at its time,
/// waves left out. Velocities and memories of `state` stay as they are but for the bed's friction, which is stretched
/// as the lines lie. The assembly is left evaluated there: forces on the ends and cuts can be read.
LinesRest rest_lines(Assembly& assembly, SystemState& state, const LineRestSettings& settings = {});

}  // namespace overbend
