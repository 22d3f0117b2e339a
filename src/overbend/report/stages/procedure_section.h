/// The procedure sheet of an operation on the line: one page for use on board.
#pragma once

#include <optional>

#include "model/description/description.h"
#include "report/page/blocks.h"
#include "results/operation_results.h"

namespace overbend {

/// Returns the steps: length of line to pay out, tension to hold, positions of vessel and head, items to watch, hold
/// points, and abort criteria. `description` gives limits and document control; empty if no stage has an equilibrium.
Blocks procedure_section(const OperationResults& results, const std::optional<Description>& description);

}  // namespace overbend
