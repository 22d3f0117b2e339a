/// A goal seek as lines on the terminal.
#pragma once

#include <string>

#include "results/seek_results.h"

namespace overbend {

/// Answer, conditions, further answers, jumps and what is to be said of them.
std::string seek_lines(const SeekResults& results);

}  // namespace overbend
