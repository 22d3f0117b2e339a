/// Data of the figures of lines that stand by themselves.
#pragma once

#include "base/json.h"
#include "results/dynamic_results.h"

namespace overbend {

/// Nodes of every line, SI. `in_time`: of a run, in whose place the values at rest stand without one.
Json line_figure_data(const std::vector<LineResult>& lines, const std::vector<LineDynamics>& in_time);

}  // namespace overbend
