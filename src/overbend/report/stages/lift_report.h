/// The report of a lift.
#pragma once

#include <optional>
#include <string>

#include "model/description/description.h"
#include "results/operation_results.h"

namespace overbend {

/// Parts between the front page and the inputs: figures and tables of all stages. What the stages ask for is in
/// `description`, where there is one. `figure` counts the figures.
std::string lift_sections(const OperationResults& results, const std::optional<Description>& description, int& figure);

}  // namespace overbend
