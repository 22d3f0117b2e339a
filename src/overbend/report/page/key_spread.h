/// The one source of what a key quantity did over time: least, largest, mean and scatter of every step. Rows of
/// histories are further apart and miss the ends.
#pragma once

#include <optional>
#include <string>

#include "results/dynamic_results.h"

namespace overbend {

/// Of the history or extreme of this name ("top_tension", "overbend_von_mises_peak", "support/ramp 1/reaction"); none
/// where the results keep only its rows.
std::optional<Spread> key_spread(const DynamicResults& results, const std::string& name);

}  // namespace overbend
