/// The hull of a description as its rest on mooring lines needs it.
#pragma once

#include "moorings/equilibrium.h"

namespace overbend {

/// Whether the hull is free to move on its lines: it has hydrostatics or floats in coupled motion.
bool hull_is_free(const Description& description);

/// Heading, heel and trim as drawn; restoring from `vessel.hydrostatics`, or from the file of a coupled hull about its
/// origin; `vessel.loads`. No ballast yet.
HullAtRest hull_at_rest(const Description& description);

/// Ballast that keeps heave, roll and pitch as drawn at the place where the lines and loads let the hull lie; adds it
/// to the steady load. `at`: surge, sway and yaw to start from.
RestOutcome trim_ballast(const MooringSpread& spread, HullAtRest& hull, const HullOffset& at);

}  // namespace overbend
