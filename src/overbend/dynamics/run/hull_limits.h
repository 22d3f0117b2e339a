/// Where the equations of a hull that floats free end.
#pragma once

#include <optional>

#include "statics/solver/statics.h"
#include "system/system.h"

namespace overbend {

/// Why a state cannot be followed further, with its time; nothing where no free body is beyond what its equations hold
/// for (hull_refusal).
std::optional<StaticFailure> hull_failure(const System& system, const SystemState& state);

}  // namespace overbend
