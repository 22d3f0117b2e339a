/// A hull on its mooring lines before anything is done with it: lengths, pose, ballast.
#pragma once

#include <variant>

#include "moorings/hull_at_rest.h"
#include "moorings/planner.h"
#include "statics/solver/statics.h"

namespace overbend {

/// The hull on its lines at one stage.
struct MooredHull {
  MooringSpread spread;
  HullAtRest hull;
  RestOutcome rest;
  bool free = true;
};

TensionBounds bounds_of(const MooringsDescription& moorings);

/// Hull and lines as described, nothing solved; or why the lines cannot be so.
std::variant<MooredHull, StaticFailure> moored_hull(const Model& model);

/// Pose of the hull with the lengths it has, or the lines alone where the hull is held.
void find_pose(MooredHull& moored);

/// The state that an analysis starts with: lengths or pose, and ballast. `moored.hull.steady` may hold what else acts.
void find_rest_at_start(const Description& description, MooredHull& moored);

/// A line that would have to break to reach.
MooringFault broken_line(const MooredHull& moored);

}  // namespace overbend
