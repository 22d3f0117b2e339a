/// Fatigue of welds while the pipe is laid: a table of the spots, and what the figure draws.
#pragma once

#include <string>

#include "base/json.h"
#include "results/dynamic_results.h"

namespace overbend {

/// HTML; nothing without fatigue. `figure` is counted on.
std::string fatigue_section(const StaticResults& statics, const DynamicResults& results, int& figure);

/// Damage per hour along the line from the tensioner on, by spot; null without fatigue.
Json fatigue_figure_data(const StaticResults& statics, const DynamicResults& results);

}  // namespace overbend
