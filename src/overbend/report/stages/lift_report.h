/// The report of a lift.
#pragma once

#include <string>

#include "results/operation_results.h"

namespace overbend {

/// Parts between the front page and the inputs: figures and tables of all stages. `figure` counts the figures.
std::string lift_sections(const OperationResults& results, int& figure);

}  // namespace overbend
