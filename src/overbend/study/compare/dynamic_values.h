/// The single numbers of a dynamic analysis, by the names that they have in summary.json.
#pragma once

#include <vector>

#include "results/dynamic_results.h"
#include "study/sensitivity/result_values.h"

namespace overbend {

/// Tensions and places over time, extremes of the regions, reactions of the supports, the largest utilisation.
std::vector<ResultValue> dynamic_values(const StaticResults& statics, const DynamicResults& results);

}  // namespace overbend
