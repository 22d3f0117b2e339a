/// The section on lines that stand by themselves.
#pragma once

#include "report/page/blocks.h"
#include "results/dynamic_results.h"

namespace overbend {

/// Tiles, figures and tables; empty without lines. `dynamics`: of a run, or null.
Blocks lines_section(const StaticResults& statics, const DynamicResults* dynamics);

}  // namespace overbend
