/// Validity limits of the equations of floating bodies.
#pragma once

#include <optional>

#include "statics/solver/statics.h"
#include "system/system.h"

namespace overbend {

/// Returns a failure with its time if a free body exceeds the validity of its equations (hull_limit_message); empty
/// otherwise.
std::optional<StaticFailure> hull_failure(const System& system, const SystemState& state);

}  // namespace overbend
