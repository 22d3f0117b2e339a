/// Data for the figures of a comparison.
#pragma once

#include "base/json.h"
#include "results/comparison_results.h"

namespace overbend {

/// Returns for the tensioner: histories in kN and m over the whole run (history_trace()) and in detail, its states as
/// [from, to, state], range and limit, null without one. For contact: boxes with the results of each variant, SI.
Json comparison_data(const Comparison& comparison);

}  // namespace overbend
