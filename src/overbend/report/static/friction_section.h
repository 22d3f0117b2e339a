/// What friction decides: the pipe on its route, and the limits between which the state lies.
#pragma once

#include <string>

#include "results/static_results.h"

namespace overbend {

/// HTML; empty where the pipe lies straight behind the barge and no limits were solved.
std::string friction_section(const StaticResults& results);

}  // namespace overbend
