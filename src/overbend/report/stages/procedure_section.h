/// The procedure sheet of an operation on the line: one page that goes on board.
#pragma once

#include <optional>

#include "model/description/description.h"
#include "report/page/blocks.h"
#include "results/operation_results.h"

namespace overbend {

/// Step by step: how far the line goes, the tension to hold, where barge and head are then, what to watch, where to
/// pause, and what ends the operation. `description` gives limits and document control; empty where no stage stands.
Blocks procedure_section(const OperationResults& results, const std::optional<Description>& description);

}  // namespace overbend
