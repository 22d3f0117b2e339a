/// The cable of a line dragged along the bed, whose length follows from where its winch stands.
#pragma once

#include <optional>

#include "statics/solver/static_ways.h"
#include "statics/solver/statics.h"

namespace overbend {

/// From an equilibrium with the wanted tension: changes the unstressed length of the cable until its end is at the
/// winch, keeping the tension. Nothing to do for lines that are not dragged. False where no equilibrium is found on the
/// way. The mesh keeps its nodes, those of the cable closer together or further apart.
bool reach_winch(StaticCase& at, const LinePast& past);

/// Why the equilibrium found of a line that is dragged cannot be meant: it is compressed somewhere, or the winch has
/// less cable than it takes. None of other lines.
std::optional<StaticFailure> check_dragged(StaticCase& at);

}  // namespace overbend
