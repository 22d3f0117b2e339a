/// Histories of a floating hull and its mooring lines, in the form of report/dynamic/history_data.h.
#pragma once

#include "base/json.h"
#include "results/dynamic_results.h"

namespace overbend {

/// Returns the group "operation": histories of pipe and vessel during a pull-ahead.
Json operation_history_data(const DynamicResults& results);

/// Returns the groups "offset" (of the vessel, each with its low-frequency part under "slow") and "moorings" (tension
/// at every fairlead).
Json mooring_history_data(const DynamicResults& results);

}  // namespace overbend
