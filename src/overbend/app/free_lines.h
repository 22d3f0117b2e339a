/// Lines that stand by themselves, as lines on the terminal.
#pragma once

#include <string>

#include "results/dynamic_results.h"

namespace overbend {

/// What is fixed to the pipe that is laid; empty where nothing is.
std::string attachment_lines(const StaticResults& results);

/// At rest; empty without lines.
std::string lines_at_rest(const std::vector<LineResult>& lines);

/// With a run's tensions.
std::string lines_in_time(const std::vector<LineResult>& lines, const std::vector<LineDynamics>& in_time);

}  // namespace overbend
