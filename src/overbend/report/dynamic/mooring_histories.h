/// Histories of a floating hull and its mooring lines, as report/dynamic/history_data.h has those of the lay.
#pragma once

#include "base/json.h"
#include "results/dynamic_results.h"

namespace overbend {

/// Group "operation": what pipe and vessel have while the vessel is pulled ahead, below each other.
Json operation_history_data(const DynamicResults& results);

/// Groups "offset" (of the vessel, each with its slow part under "slow") and "moorings" (tension at every fairlead).
Json mooring_history_data(const DynamicResults& results);

}  // namespace overbend
