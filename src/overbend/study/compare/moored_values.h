/// Scalar results of a vessel on mooring lines, with their names in summary.json.
#pragma once

#include <vector>

#include "results/dynamic_results.h"
#include "study/sensitivity/result_values.h"

namespace overbend {

/// Returns the vessel's offset, its natural periods, and the loads of its lines, also at the stages of an operation.
std::vector<ResultValue> mooring_values(const MooringResults& results);

/// Returns motions with their slow and wave parts, and tensions over time; empty for a run without moorings.
std::vector<ResultValue> moored_dynamic_values(const DynamicResults& results);

}  // namespace overbend
