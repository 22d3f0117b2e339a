/// Scalar results of a dynamic analysis, with their names in summary.json.
#pragma once

#include <vector>

#include "results/dynamic_results.h"
#include "study/sensitivity/result_values.h"

namespace overbend {

/// Returns tensions and positions over time, extremes of the regions, reactions of the supports, and the maximum
/// utilisation.
std::vector<ResultValue> dynamic_values(const StaticResults& statics, const DynamicResults& results);

}  // namespace overbend
