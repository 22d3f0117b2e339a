/// Data of the figures of a comparison.
#pragma once

#include "base/json.h"
#include "results/comparison_results.h"

namespace overbend {

/// Of the tensioner: histories in kN and m over the whole run (history_trace()) and close up, its states as [from, to,
/// state], range and limit, null where there is none. Of contact: boxes with what each variant gave, SI.
Json comparison_data(const Comparison& comparison);

}  // namespace overbend
