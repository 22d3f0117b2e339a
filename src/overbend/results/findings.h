/// Findings of results as a whole.
#pragma once

#include "base/finding.h"
#include "results/dynamic_results.h"
#include "results/operation_results.h"
#include "results/verdict.h"

namespace overbend {

/// Of a run in time: its own, then those of the static state that it began from.
Findings all_findings(const StaticResults& statics, const DynamicResults& results);

/// Stages without equilibrium first, then the findings of the operation and of its stages, each once, with the numbers
/// of the stages that have it where not all do.
Findings operation_findings(const OperationResults& results);

/// Of one stage: its checks with its findings; exceeded where it has no equilibrium.
Verdict stage_verdict(const StageResult& stage);

/// The checks of all stages in one table.
CheckTable operation_checks(const OperationResults& results);

/// Of all stages together; exceeded where a stage has no equilibrium.
Verdict operation_verdict(const OperationResults& results);

}  // namespace overbend
