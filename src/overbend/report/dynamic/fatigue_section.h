/// Fatigue of welds during laying: a table of the spots, and the data of the figure.
#pragma once

#include "base/json.h"
#include "report/page/blocks.h"
#include "results/dynamic_results.h"

namespace overbend {

/// Returns the section; empty without fatigue.
Blocks fatigue_section(const StaticResults& statics, const DynamicResults& results);

/// Returns the damage per hour along the line from the tensioner on, by spot; null without fatigue.
Json fatigue_figure_data(const StaticResults& statics, const DynamicResults& results);

}  // namespace overbend
