/// Tables of stand-alone lines.
#pragma once

#include <vector>

#include "results/dynamic_results.h"
#include "results/tables/table.h"

namespace overbend {

/// Returns the static results of the lines.
Table lines_at_rest(const std::vector<LineResult>& lines);

/// Returns static tension and force at both ends of each line; over time if `in_time`, with the same lines, is not
/// empty.
Table line_ends(const std::vector<LineResult>& lines, const std::vector<LineDynamics>& in_time);

}  // namespace overbend
