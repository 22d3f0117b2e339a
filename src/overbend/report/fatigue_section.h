/// Fatigue of welds while the pipe is laid: a table of the spots, and what the figure draws.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "results/dynamic_results.h"

namespace overbend {

/// HTML; nothing without fatigue. `figure` is counted on.
std::string fatigue_section(const StaticResults& statics, const DynamicResults& results, int& figure);

/// Damage per hour along the line from the tensioner on, by spot; null without fatigue.
nlohmann::json fatigue_figure_data(const StaticResults& statics, const DynamicResults& results);

}  // namespace overbend
