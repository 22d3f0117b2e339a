/// Models whose statics as a pipe are not supported.
#pragma once

#include <optional>
#include <string>

#include "statics/solver/statics.h"

namespace overbend {

/// Returns a failure if the model is not a pipe on a held vessel; nullopt if it is.
std::optional<StaticFailure> unsupported_in_statics(const Description& description);

/// Returns an error message if the model has no pipe; `what`: the requested analysis, such as "a lay table".
std::optional<std::string> missing_pipe_message(const Description& description, const std::string& what);

}  // namespace overbend
