/// Text of sensitivities for the terminal.
#pragma once

#include <string>

#include "results/sensitivity_results.h"

namespace overbend {

/// Returns, for each key result, the three inputs whose tolerance has the largest effect.
std::string sensitivity_lines(const SensitivityResults& sensitivities);

}  // namespace overbend
