/// Single source of the statistics of a key quantity over time: minimum, maximum, mean and standard deviation over
/// every step. Output rows are less frequent and miss the extremes.
#pragma once

#include <optional>
#include <string>

#include "results/dynamic_results.h"

namespace overbend {

/// Returns the statistics of the history or extreme of this name ("top_tension", "overbend_von_mises_peak",
/// "support/ramp 1/reaction"); none if the results contain only its rows.
std::optional<SummaryStatistics> key_statistics(const DynamicResults& results, const std::string& name);

}  // namespace overbend
