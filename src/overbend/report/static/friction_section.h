/// Effect of friction: the pipe on its route, and the limit cases that bound the state.
#pragma once

#include "report/page/blocks.h"
#include "results/static_results.h"

namespace overbend {

/// Returns the section; empty if the pipe is straight behind the vessel and no limit cases were solved.
Blocks friction_section(const StaticResults& results);

}  // namespace overbend
