/// Assumptions of the dynamic analysis.
#pragma once

#include <string>
#include <vector>

#include "model/model.h"

namespace overbend {

/// Appends one sentence for each assumption of a dynamic analysis. The model has `analysis.dynamic`.
void assume_dynamics(std::vector<std::string>& list, const Model& model);

}  // namespace overbend
