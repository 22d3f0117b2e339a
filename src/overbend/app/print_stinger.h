/// Text of a hinged stinger for the terminal.
#pragma once

#include <string>

#include "results/static_results.h"

namespace overbend {

/// Returns a line for each section: angle, hinge force, stop or holding moment, natural period. Empty for a fixed
/// stinger.
std::string stinger_lines(const StaticResults& results);

}  // namespace overbend
