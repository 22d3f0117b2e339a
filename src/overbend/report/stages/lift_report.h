/// The report of a lift.
#pragma once

#include <optional>

#include "model/description/description.h"
#include "report/page/blocks.h"
#include "results/operation_results.h"

namespace overbend {

/// Parts between the front page and the inputs: figures and tables of all stages. What the stages ask for is in
/// `description`, where there is one.
Blocks lift_sections(const OperationResults& results, const std::optional<Description>& description);

}  // namespace overbend
