/// Bodies that lines are on: where they lie, how they move, what lines do to them.
#pragma once

#include "report/page/blocks.h"
#include "results/dynamic_results.h"

namespace overbend {

/// Empty without bodies. `dynamics`: of a run, or null.
Blocks bodies_section(const StaticResults& statics, const DynamicResults* dynamics);

}  // namespace overbend
