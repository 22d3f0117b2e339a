/// Mooring lines as lines of a system: elements with mass, drag and the bed's friction.
#pragma once

#include "moorings/spread.h"
#include "statics/solver/statics.h"
#include "system/assembly.h"

namespace overbend {

/// Shapes to start from, six unknowns per node, line by line.
using LineShapes = std::vector<std::vector<double>>;

/// Adds the lines of `spread`, with the lengths they have there, behind those of `system`: from their anchors on the
/// bed to their fairleads on body 0, which lies in the model's mean pose. Parted ones are left out. Returns the
/// catenaries of statics for first shapes. Lines point into `model`, which must outlive them.
LineShapes add_mooring_lines(const Model& model, const MooringSpread& spread, System& system);

/// How much a winch at the last end of a line may pay out and haul in: its last element gives it [m].
double winch_range(const Line& line);

/// The system in which its mooring lines come to rest as what has been pulled in over a
/// bed that rubs: tension falls from touchdown towards the anchor by the friction, as in a catenary. Stretches the
/// friction of `state` so that it slides that way. Across their course nothing holds them, but those whose tension ends
/// before the anchor, or that lie across a slope; no current flows on them. With friction and current they come to rest
/// from there: what lies is held by the bed, and does not drift.
System pulled_in(const System& system, SystemState& state);

/// Brings the mooring lines of a state to rest, pulled in, on bodies that stay where they are; or says which does not.
std::optional<StaticFailure> rest_mooring_lines(const System& system, const std::vector<RigidMotion>& bodies,
                                                SystemState& state);

/// Names of the lines that are there, in the order of the system.
std::vector<std::string> mooring_names(const MooringSpread& spread);

}  // namespace overbend
