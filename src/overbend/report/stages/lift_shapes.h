/// The side view of a lift: all lines at every stage, attachments, water level and seabed.
#pragma once

#include <optional>

#include "model/description/description.h"
#include "report/page/blocks.h"
#include "results/operation_results.h"

namespace overbend {

/// Returns the view; empty if no stage has an equilibrium.
Blocks lift_side_view(const OperationResults& results, const std::optional<Description>& description);

}  // namespace overbend
