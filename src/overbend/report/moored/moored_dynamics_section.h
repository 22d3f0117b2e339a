/// Vessel and mooring lines over time: tables of slow and wave parts.
#pragma once

#include "report/page/blocks.h"
#include "results/dynamic_results.h"

namespace overbend {

/// Nothing where the hull is not free and no line was followed.
Blocks moored_dynamics_section(const DynamicResults& results);

}  // namespace overbend
