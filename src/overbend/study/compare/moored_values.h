/// The single numbers of a vessel on mooring lines, by the names that they have in summary.json.
#pragma once

#include <vector>

#include "results/dynamic_results.h"
#include "study/sensitivity/result_values.h"

namespace overbend {

/// Where the vessel lies, its natural periods, and what its lines bear; of the stages of an operation as well.
std::vector<ResultValue> mooring_values(const MooringResults& results);

/// Motions, slow and wave part, and tensions over time; none of a run without moorings.
std::vector<ResultValue> moored_dynamic_values(const DynamicResults& results);

}  // namespace overbend
