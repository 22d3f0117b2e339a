/// Default tolerances of the time integration, from the scales of the model, for settings that the model file leaves
/// out.
#pragma once

#include "model/model.h"

namespace overbend {

struct StepScales {
  double time = 0.125;   ///< Max. step [s]; shorter steps are fractions of it.
  double length = 1e-3;  ///< Position error of a step [m].
  double force = 1e3;    ///< Impacts below this force are ignored [N].
};

/// Returns the scales of a model; never more than the defaults above, so that large structures in long waves are
/// integrated like ships in typical seas.
StepScales step_scales(const Model& model);

}  // namespace overbend
