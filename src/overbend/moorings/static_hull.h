/// Hull data of a description for its equilibrium on mooring lines.
#pragma once

#include "model/description/description.h"
#include "moorings/equilibrium.h"

namespace overbend {

/// Nominal heading, heel and trim; restoring from `vessel.hydrostatics`, or from the file of a coupled hull about its
/// origin; `vessel.loads`; dynamic positioning to the nominal position. No ballast yet.
StaticHull make_static_hull(const Description& description);

/// Finds the ballast that keeps the nominal heave, roll and pitch at the equilibrium position under lines and loads,
/// and adds it to the steady load. `start`: initial surge, sway and yaw.
HullEquilibrium trim_ballast(const MooringSpread& spread, StaticHull& hull, const HullOffset& start);

}  // namespace overbend
