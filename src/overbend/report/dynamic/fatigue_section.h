/// Fatigue of welds while the pipe is laid: a table of the spots, and what the figure draws.
#pragma once

#include "base/json.h"
#include "report/page/blocks.h"
#include "results/dynamic_results.h"

namespace overbend {

/// Nothing without fatigue.
Blocks fatigue_section(const StaticResults& statics, const DynamicResults& results);

/// Damage per hour along the line from the tensioner on, by spot; null without fatigue.
Json fatigue_figure_data(const StaticResults& statics, const DynamicResults& results);

}  // namespace overbend
