/// Verdict over all stages of an operation on the line.
#pragma once

#include <vector>

#include "base/finding.h"
#include "report/page/front_page.h"
#include "results/operation_results.h"
#include "results/verdict.h"

namespace overbend {

/// Returns the verdict of all stages, which names the stage of the maximum utilisation.
Verdict verdict_with_stage(const OperationResults& results);

/// Returns the governing check of each region over all stages, each with its stage.
std::vector<Utilisation> operation_bars(const OperationResults& results);

}  // namespace overbend
