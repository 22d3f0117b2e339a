/// A stinger on hinges on the terminal.
#pragma once

#include <string>

#include "results/static_results.h"

namespace overbend {

/// A line for each section: angle, hinge force, what holds it, period. Empty of a fixed stinger.
std::string stinger_lines(const StaticResults& results);

}  // namespace overbend
