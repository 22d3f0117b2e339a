/// A stinger on hinges in the report.
#pragma once

#include "report/page/blocks.h"
#include "results/static_results.h"

namespace overbend {

/// Returns angle, hinge force and tanks of each section in equilibrium; empty for a fixed stinger.
Blocks stinger_section(const StaticResults& results);

}  // namespace overbend
