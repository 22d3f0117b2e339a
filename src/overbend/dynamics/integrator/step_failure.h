/// Why a step in time could not be taken.
#pragma once

#include "dynamics/integrator/time_step.h"
#include "statics/solver/statics.h"

namespace overbend {

/// In words, with the place that is worst: of the shortest step, from `time` [s].
StaticFailure step_failure(const StepReport& report, const System& system, double time);

}  // namespace overbend
