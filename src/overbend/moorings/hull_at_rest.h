/// The hull of a description as its rest on mooring lines needs it.
#pragma once

#include "model/description/description.h"
#include "moorings/equilibrium.h"

namespace overbend {

/// Heading, heel and trim as drawn; restoring from `vessel.hydrostatics`, or from the file of a coupled hull about its
/// origin; `vessel.loads`; dynamic positioning to the place as drawn. No ballast yet.
HullAtRest hull_at_rest(const Description& description);

/// Ballast that keeps heave, roll and pitch as drawn at the place where the lines and loads let the hull lie; adds it
/// to the steady load. `at`: surge, sway and yaw to start from.
RestOutcome trim_ballast(const MooringSpread& spread, HullAtRest& hull, const HullOffset& at);

}  // namespace overbend
