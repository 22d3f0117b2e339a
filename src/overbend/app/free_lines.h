/// Lines that stand by themselves and the bodies that they are on, as lines on the terminal.
#pragma once

#include <string>

#include "results/dynamic_results.h"

namespace overbend {

/// What is fixed to the pipe that is laid; empty where nothing is.
std::string attachment_lines(const StaticResults& results);

/// At rest; empty without lines.
std::string lines_at_rest_text(const std::vector<LineResult>& lines);

/// With a run's tensions.
std::string lines_in_time(const std::vector<LineResult>& lines, const std::vector<LineDynamics>& in_time);

/// Where bodies lie and what lines do to them; empty without bodies.
std::string bodies_at_rest(const std::vector<BodyResult>& bodies);
/// How far they went in a run, and how hard lines pulled.
std::string bodies_in_time(const std::vector<BodyDynamics>& bodies);

}  // namespace overbend
