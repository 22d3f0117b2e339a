/// What results hang on, on the terminal.
#pragma once

#include <string>

#include "results/sensitivity_results.h"

namespace overbend {

/// For each key result the three inputs whose tolerance moves it most.
std::string sensitivity_lines(const SensitivityResults& sensitivities);

}  // namespace overbend
