/// Assumptions of the dynamic analysis.
#pragma once

#include "base/assumption.h"
#include "model/model.h"

namespace overbend {

/// Appends one sentence for each assumption of a dynamic analysis. The model has `analysis.dynamic`.
void assume_dynamics(Assumptions& list, const Model& model);

}  // namespace overbend
