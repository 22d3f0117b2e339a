/// Text of weld fatigue for the terminal.
#pragma once

#include <string>

#include "results/dynamic_results.h"

namespace overbend {

/// Returns a line for each spot of the weld; empty without fatigue.
std::string fatigue_lines(const DynamicResults& results);

}  // namespace overbend
