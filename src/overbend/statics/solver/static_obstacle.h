/// What the statics of a pipe cannot answer for.
#pragma once

#include <optional>
#include <string>

#include "statics/solver/statics.h"

namespace overbend {

/// Why the model's equilibrium is none of a pipe on a held vessel; empty where it is one.
std::optional<StaticFailure> static_obstacle(const Description& description);

/// Why there is nothing of a laid pipe to make of the model; `what`: "a lay table". Empty where it has a pipe.
std::optional<std::string> pipe_obstacle(const Description& description, const std::string& what);

}  // namespace overbend
