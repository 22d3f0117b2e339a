/// The report of a lift.
#pragma once

#include <optional>

#include "model/description/description.h"
#include "report/page/blocks.h"
#include "results/operation_results.h"

namespace overbend {

/// Returns the sections between the front page and the inputs: figures and tables of all stages. `description`, if
/// present, contains the inputs of the stages.
Blocks lift_sections(const OperationResults& results, const std::optional<Description>& description);

}  // namespace overbend
