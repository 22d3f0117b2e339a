/// How stages of an operation on the line are spoken of, in report and page.
#pragma once

#include <optional>
#include <string>

#include "results/operation_results.h"

namespace overbend {

/// How far the line has gone at the stage: cable out, pipe out, passed or ahead, whichever it says [m].
std::optional<double> progress_of(const LayStageDescription& stage);

/// "Cable out": heading of that length.
std::string progress_name(OperationType type);

/// "Abandonment", "Start-up".
std::string operation_title(OperationType type);

/// "5 (head over the stinger)"; the number alone where the stage has no name of its own.
std::string stage_title(const OperationResults& results, std::size_t stage);

/// Equilibrium of the first stage that has one; null without any.
const StaticResults* first_lay(const OperationResults& results);

}  // namespace overbend
