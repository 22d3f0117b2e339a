/// summary.json of other analyses than static ones, as data.
#pragma once

#include "resultfiles/summary/summary_json.h"
#include "results/operation_results.h"

namespace overbend {

/// Returns the summary of a dynamic analysis: that of its static analysis, and the key `dynamic`.
Json dynamic_summary_json(const StaticResults& statics, const DynamicResults& results);

/// Returns the summary of an operation on the line.
Json operation_summary_json(const OperationResults& results);

/// Returns a stage in that summary.
Json stage_summary_json(const StageResult& stage);

}  // namespace overbend
