/// Initial state of a hull on its mooring lines: lengths, pose, ballast.
#pragma once

#include <variant>

#include "moorings/planner.h"
#include "moorings/static_hull.h"
#include "statics/solver/statics.h"

namespace overbend {

/// Equilibrium of the hull on its lines at one stage.
struct MooredHull {
  MooringSpread spread;
  StaticHull hull;
  HullEquilibrium rest;
  bool free = true;
};

/// Returns the tension bounds of the moorings: minimum tension and working load [N].
TensionBounds make_tension_bounds(const MooringsDescription& moorings);

/// Returns hull and lines as described, unsolved; or the reason why the lines are invalid.
std::variant<MooredHull, StaticFailure> moored_hull(const Model& model);

/// Finds the pose of the hull with its present lengths, or the lines alone if the hull is held.
void find_pose(MooredHull& moored);

/// Finds the initial state of an analysis: lengths or pose, and ballast. `moored.hull.steady` may contain other loads.
void find_initial_equilibrium(const Description& description, MooredHull& moored);

/// Returns an error for a line that would have to break to reach its anchor.
MooringError broken_line(const MooredHull& moored);

}  // namespace overbend
