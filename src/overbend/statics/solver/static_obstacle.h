/// What the statics of a pipe cannot answer for.
#pragma once

#include <optional>

#include "statics/solver/statics.h"

namespace overbend {

/// Why the model's equilibrium is none of a pipe on a held vessel; empty where it is one.
std::optional<StaticFailure> static_obstacle(const Description& description);

}  // namespace overbend
