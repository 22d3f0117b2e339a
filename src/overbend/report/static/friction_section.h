/// What friction decides: the pipe on its route, and the limits between which the state lies.
#pragma once

#include "report/page/blocks.h"
#include "results/static_results.h"

namespace overbend {

/// Empty where the pipe lies straight behind the barge and no limits were solved.
Blocks friction_section(const StaticResults& results);

}  // namespace overbend
