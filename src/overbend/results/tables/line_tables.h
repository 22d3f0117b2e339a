/// Tables of lines by themselves.
#pragma once

#include <vector>

#include "results/dynamic_results.h"
#include "results/tables/table.h"

namespace overbend {

Table lines_at_rest(const std::vector<LineResult>& lines);

/// Tension and force at both ends of each, at rest; over time where `in_time`, which is of the same lines, is not
/// empty.
Table line_ends(const std::vector<LineResult>& lines, const std::vector<LineDynamics>& in_time);

}  // namespace overbend
