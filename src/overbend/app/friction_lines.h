/// Lines on the terminal: the pipe on its route, and what friction decides.
#pragma once

#include <string>

#include "results/static_results.h"

namespace overbend {

/// Empty where the pipe lies straight behind the barge and nothing has friction.
std::string friction_lines(const StaticResults& results);

}  // namespace overbend
