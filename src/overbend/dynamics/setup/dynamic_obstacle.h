/// Models that have statics but no dynamic analysis.
#pragma once

#include <optional>

#include "dynamics/integrator/dynamics.h"
#include "statics/solver/statics.h"

namespace overbend {

/// The model has no analysis.dynamic.
StaticFailure without_dynamics();

/// Why a dynamic analysis of a model is not possible although its statics are; nothing when it is.
std::optional<StaticFailure> dynamic_obstacle(const Model& model);

}  // namespace overbend
