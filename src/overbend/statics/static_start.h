/// From the model to the first guess of a static solution, and the reasons for which there can be none.
#pragma once

#include <optional>
#include <string>

#include "statics/lay_shape.h"
#include "statics/static_system.h"
#include "statics/statics.h"
#include "system/line_mesh.h"

namespace overbend {

struct StartingPoint {
  LayShape shape;
  MeshZones zones;
  LineTargetValue target;
  double tail = 0.0;  ///< Laid length behind touchdown [m].
  std::optional<StaticFailure> failure;
  bool shaped = true;  ///< Whether there is a shape; see point_beside.
};

/// What the model wants of the line: the tension at the tensioner, or else the place of the anchor.
LineTargetValue wanted_of(const Description& description);

StartingPoint starting_point(const Model& model, const LayPlane& plane);

/// The same beside a solution on a mesh that the model fits: where the shape of the guess decides nothing, on a level
/// bed and a straight route, it is left out and the zones are those of the solution's mesh.
StartingPoint point_beside(const Model& model, const LayPlane& plane, const StaticSolution& solution);

/// The guess at the nodes of the system's mesh.
LineState sample_shape(const StaticSystem& system, const LayShape& shape);

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

/// Length from the tensioner to the last roller that the pipe passes [m]; from the contacts of the last evaluation.
double support_end(const StaticSystem& system);

/// A box that the pipe lies beside.
struct BoxLeft {
  std::string name;
  double off_end = 0.0;  ///< Beyond the end of its bottom roller [m].
  bool sided = false;    ///< Whether it has side rollers, over which the pipe has climbed.
};

/// The first, seen from the tensioner, in the state evaluated last; nothing where the pipe lies over all boxes, or
/// so far away that the state means nothing.
std::optional<BoxLeft> first_box_left(const Model& model, const StaticSystem& system);
/// How far, and whether something should have held the pipe.
std::string off_end_words(const BoxLeft& left);

/// A pipe that touches none of its supports is not held by them: says so. Uses the contacts of the last evaluation.
std::optional<StaticFailure> check_supports(const Model& model, const StaticSystem& system);

/// A mesh beyond what is built says so before it is.
std::optional<StaticFailure> too_many_elements(const Model& model, const MeshZones& zones);

/// The line balances only with the far end pushed: `least` is the tension at the top where that begins [N].
StaticFailure compressed_at_seabed(double tension, double least);

StaticFailure never_touches(const Model& model, double length);

}  // namespace overbend
