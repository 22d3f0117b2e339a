/// What a model is warned of before anything is solved.
#pragma once

#include <string>
#include <vector>

#include "base/finding.h"
#include "model/model.h"

namespace overbend {

/// The warnings of all results that do not depend on a solution: of the model, of ramp and stinger, and of a floating
/// hull's coefficients.
Findings input_findings(const Model& model);

}  // namespace overbend
