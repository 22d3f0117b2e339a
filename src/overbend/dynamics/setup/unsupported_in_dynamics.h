/// Models that have a static but no dynamic analysis.
#pragma once

#include <optional>

#include "dynamics/integrator/dynamics.h"
#include "statics/solver/statics.h"

namespace overbend {

/// Returns the failure of a model without analysis.dynamic.
StaticFailure missing_dynamic_analysis();

/// Returns the reason why a dynamic analysis of a model is unsupported although its statics are; empty if it is
/// supported.
std::optional<StaticFailure> unsupported_in_dynamics(const Model& model);

}  // namespace overbend
