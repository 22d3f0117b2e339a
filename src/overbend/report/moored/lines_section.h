/// The section on lines that stand by themselves.
#pragma once

#include <string>

#include "results/dynamic_results.h"
#include "results/static_results.h"

namespace overbend {

/// Tiles, figures and tables; empty without lines. `dynamics`: of a run, or null. `figure` is counted on.
std::string lines_section(const StaticResults& statics, const DynamicResults* dynamics, int& figure);

}  // namespace overbend
