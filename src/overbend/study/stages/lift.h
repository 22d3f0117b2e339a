/// A lift, all its stages: lines hauled and paid out, the vessel moved, ends welded.
#pragma once

#include <functional>
#include <optional>

#include "model/description/description.h"
#include "results/operation_results.h"
#include "statics/solver/statics.h"

namespace overbend {

/// Brings the lines from stage to stage, as solve_operation() does it of a lay. A stage that cannot be reached says
/// why; those after it go on from the last that stands.
OperationResults solve_lift(const Description& description,
                            const std::function<bool(const StageResult&, std::size_t of)>& told);

/// The first stage with a line that cannot reach, as a fault of the file; none where all can.
std::optional<StaticFailure> lift_obstacle(const Description& description);

}  // namespace overbend
