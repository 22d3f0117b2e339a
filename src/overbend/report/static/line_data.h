/// Data for the figures of stand-alone lines.
#pragma once

#include "base/json.h"
#include "results/dynamic_results.h"

namespace overbend {

/// Returns the nodes of every line, SI. `in_time`: results of a run; without them the static values are used.
Json line_figure_data(const std::vector<LineResult>& lines, const std::vector<LineDynamics>& in_time);

}  // namespace overbend
