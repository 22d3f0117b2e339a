/// Text of separate lines and bodies for the terminal.
#pragma once

#include <string>

#include "results/dynamic_results.h"

namespace overbend {

/// Returns the items attached to the pipe; empty if there are none.
std::string attachment_lines(const StaticResults& results);

/// Returns the static results of lines; empty without lines.
std::string lines_at_rest_text(const std::vector<LineResult>& lines);

/// Returns the results of lines with the tension range of a run.
std::string lines_in_time(const std::vector<LineResult>& lines, const std::vector<LineDynamics>& in_time);

/// Returns the static positions of bodies and the forces of lines on them; empty without bodies.
std::string bodies_at_rest(const std::vector<BodyResult>& bodies);
/// Returns the range of the line forces on bodies during a run.
std::string bodies_in_time(const std::vector<BodyDynamics>& bodies);

}  // namespace overbend
