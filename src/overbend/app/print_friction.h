/// Text of the route and of roller friction limits for the terminal.
#pragma once

#include <string>

#include "results/static_results.h"

namespace overbend {

/// Returns an empty text if the pipe lies straight behind the vessel and there is no friction.
std::string friction_lines(const StaticResults& results);

}  // namespace overbend
