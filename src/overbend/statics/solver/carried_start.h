/// A static state carried over to where it is the start of the next solution: to another mesh, to ends and a vessel
/// that are elsewhere.
#pragma once

#include "statics/equations/static_system.h"
#include "statics/initial_shape/lay_shape.h"

namespace overbend {

/// Puts the far end to the height at which an anchor pins it, where one does, and along the route where it is held so.
void pin_far_end(const StaticSystem& system, LineState& state);

/// A state carried over to another mesh; nodes are matched by their distance from the tensioner, a longer tail goes on
/// along the bed.
LineState interpolate(const LineMesh& from, const LineState& state, const LineMesh& to, const LayPlane& plane);

/// Moves a state that was solved beside a vessel of pose `before`, with its ends elsewhere: what lies over the
/// supports, up to `last_support` from the tensioner, goes with the vessel, what lies on the bed with the route, what
/// hangs between with both. By what its top misses the tensioner then it goes along the route as a whole, across it by
/// its share of the length, in height down to the touchdown. What Newton's method starts from.
void bring_to_ends(const StaticSystem& system, const VesselPose& before, double last_support, LineState& state);

}  // namespace overbend
