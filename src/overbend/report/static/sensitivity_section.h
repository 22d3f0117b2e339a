/// The section "What this result hangs on".
#pragma once

#include "report/page/blocks.h"
#include "results/sensitivity_results.h"

namespace overbend {

/// A tornado for each key result: how far the tolerance of each of the ten foremost inputs moves it; behind them a
/// table of derivatives.
Blocks sensitivity_section(const SensitivityResults& sensitivities);

}  // namespace overbend
