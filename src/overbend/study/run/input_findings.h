/// Warnings of a model before anything is solved.
#pragma once

#include <string>
#include <vector>

#include "base/finding.h"
#include "model/model.h"

namespace overbend {

/// Returns all warnings that do not depend on a solution: of the model, of ramp and stinger, and of the coefficients of
/// a floating hull.
Findings input_findings(const Model& model);

}  // namespace overbend
