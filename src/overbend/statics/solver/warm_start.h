/// Warm start: a static state transferred to the next problem, with another mesh, other ends and another vessel pose.
#pragma once

#include "statics/equations/static_system.h"
#include "statics/initial_shape/lay_shape.h"

namespace overbend {

/// Moves the far end to the height of its anchor, if it has one, and onto the route if it is held there.
void pin_far_end(const StaticSystem& system, LineState& state);

/// Interpolates a state to another mesh. Nodes are matched by their distance from the tensioner; a longer laid part
/// continues along the bed.
LineState interpolate(const LineMesh& from, const LineState& state, const LineMesh& to, const LayPlane& plane);

/// Moves a state solved at vessel pose `before`, with its ends elsewhere, as an initial guess for Newton's method. The
/// part over the supports, up to `last_support` from the tensioner [m], moves with the vessel, the part on the bed with
/// the route, and the suspended part between them with both. The remaining error of the top at the tensioner is removed
/// along the route by a translation, across it in proportion to arc length, and in height down to the touchdown.
void move_to_ends(const StaticSystem& system, const VesselPose& before, double last_support, LineState& state);

}  // namespace overbend
