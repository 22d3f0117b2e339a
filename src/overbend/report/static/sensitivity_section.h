/// The section "What this result hangs on".
#pragma once

#include <string>

#include "results/sensitivity_results.h"

namespace overbend {

/// A tornado for each key result: how far the tolerance of each of the ten foremost inputs moves it; behind them a
/// table of derivatives. `figure` counts the figures of the page.
std::string sensitivity_section(const SensitivityResults& sensitivities, int& figure);

}  // namespace overbend
