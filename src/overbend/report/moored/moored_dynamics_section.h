/// Vessel and mooring lines over time: tables of low-frequency and wave-frequency parts.
#pragma once

#include "report/page/blocks.h"
#include "results/dynamic_results.h"

namespace overbend {

/// Returns the section; empty for a fixed hull without lines in the dynamic model.
Blocks moored_dynamics_section(const DynamicResults& results);

}  // namespace overbend
