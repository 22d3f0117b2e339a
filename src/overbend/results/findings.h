/// Findings and verdicts of results as a whole.
#pragma once

#include "base/finding.h"
#include "results/dynamic_results.h"
#include "results/operation_results.h"
#include "results/verdict.h"

namespace overbend {

/// Returns the findings of a dynamic run: its own, then those of the static state that it started from.
Findings all_findings(const StaticResults& statics, const DynamicResults& results);

/// Returns stages without equilibrium first, then the findings of the operation and of its stages, each once, with the
/// numbers of the stages unless all have it.
Findings operation_findings(const OperationResults& results);

/// Returns the verdict of one stage from its checks and findings; exceeded without an equilibrium.
Verdict stage_verdict(const StageResult& stage);

/// Returns the checks of all stages in one table.
CheckTable operation_checks(const OperationResults& results);

/// Returns the verdict of all stages together; exceeded if a stage has no equilibrium.
Verdict operation_verdict(const OperationResults& results);

}  // namespace overbend
