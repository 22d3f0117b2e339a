/// Text of a goal seek for the terminal.
#pragma once

#include <string>

#include "results/seek_results.h"

namespace overbend {

/// Returns the solution, the conditions, further solutions, jumps and remarks.
std::string seek_lines(const SeekResults& results);

}  // namespace overbend
