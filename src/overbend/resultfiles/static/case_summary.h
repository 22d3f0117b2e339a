/// summary.json of analyses beyond statics, as data.
#pragma once

#include "resultfiles/summary/summary_json.h"
#include "results/operation_results.h"

namespace overbend {

/// What a dynamic analysis writes: what statics write, and the key `dynamic`.
Json dynamic_summary_json(const StaticResults& statics, const DynamicResults& results);

/// What an operation on the line writes.
Json operation_summary_json(const OperationResults& results);

/// A stage there.
Json stage_summary_json(const StageResult& stage);

}  // namespace overbend
