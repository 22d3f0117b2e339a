/// Names and titles of the stages of an operation on the line, in report and page.
#pragma once

#include <optional>
#include <string>

#include "results/operation_results.h"

namespace overbend {

/// Returns the progress of the line at the stage [m]: cable out, pipe out, passed or ahead, whichever is given.
std::optional<double> stage_progress(const LayStageDescription& stage);

/// Returns the heading of that length: "Cable out".
std::string progress_name(OperationType type);

/// Returns "Abandonment", "Start-up".
std::string operation_title(OperationType type);

/// Returns "5 (head over the stinger)"; the number alone if the stage has no name.
std::string stage_title(const OperationResults& results, std::size_t stage);

/// Returns the equilibrium of the first stage that has one; null without any.
const StaticResults* first_lay(const OperationResults& results);

}  // namespace overbend
