/// Message for a time step that cannot be solved.
#pragma once

#include "dynamics/integrator/time_step.h"
#include "statics/solver/statics.h"

namespace overbend {

/// Returns the failure of the minimum step from `time` [s], with the place of the largest residual.
StaticFailure step_failure(const StepReport& report, const System& system, double time);

}  // namespace overbend
