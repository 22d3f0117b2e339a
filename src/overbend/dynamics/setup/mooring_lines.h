/// Mooring lines as lines of a system: elements with mass, drag and seabed friction.
#pragma once

#include "moorings/mooring_spread.h"
#include "statics/solver/statics.h"
#include "system/assembly.h"

namespace overbend {

/// Initial shapes, six unknowns per node, one per line.
using LineShapes = std::vector<std::vector<double>>;

/// Adds the lines of `spread`, with their lengths there, after those of `system`: from their anchors on the seabed to
/// their fairleads on body 0 in the model's mean pose. Failed lines are left out. Returns the static catenaries as
/// initial shapes. Lines point into `model`, which must outlive them.
LineShapes add_mooring_lines(const Model& model, const MooringSpread& spread, System& system);

/// Returns the length that a winch may pay out and haul in at the last end of a line, which comes from its last element
/// [m].
double winch_range(const Line& line);

/// Returns the system for the equilibrium of mooring lines pulled in along a seabed with friction: the tension
/// decreases from touchdown towards the anchor by the friction, as in a catenary. Sets the stretch of the friction in
/// `state` so that it slides in that direction. No lateral friction acts, except on lines whose tension vanishes before
/// the anchor or that lie across a slope, and no current. The final equilibrium with friction and current starts from
/// there: the seabed holds grounded parts, which do not drift.
System with_mobilised_friction(const System& system, SystemState& state);

/// Solves the equilibrium of the mooring lines of a state, with mobilised friction, on fixed bodies. Returns a failure
/// that names the first line without equilibrium.
std::optional<StaticFailure> solve_mooring_lines(const System& system, const std::vector<RigidMotion>& bodies,
                                                 SystemState& state);

/// Returns the names of the intact lines, in the order of the system.
std::vector<std::string> mooring_names(const MooringSpread& spread);

}  // namespace overbend
