/// Verdict over all stages of an operation on the line.
#pragma once

#include <vector>

#include "report/front_page.h"
#include "report/verdict.h"
#include "results/operation_results.h"

namespace overbend {

/// Exceeded where a stage cannot be, or a check or the cable is beyond its capacity at any; says at which stage.
Verdict operation_verdict(const OperationResults& results, const std::vector<WeighedWarning>& warnings);

/// The governing check of each region over all stages, and the cable, each with its stage.
std::vector<UtilisationBar> operation_bars(const OperationResults& results);

/// Failed stages first, then the warnings of the operation and of its stages, each once with the stages that have it.
std::vector<WeighedWarning> operation_warnings(const OperationResults& results);

}  // namespace overbend
