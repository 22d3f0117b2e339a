/// The section on sensitivities.
#pragma once

#include "report/page/blocks.h"
#include "results/sensitivity_results.h"

namespace overbend {

/// Returns a tornado chart for each key result: its change for the tolerance of each of the ten most influential
/// inputs; followed by a table of derivatives.
Blocks sensitivity_section(const SensitivityResults& sensitivities);

}  // namespace overbend
