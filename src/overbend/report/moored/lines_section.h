/// The section on stand-alone lines.
#pragma once

#include "report/page/blocks.h"
#include "results/dynamic_results.h"

namespace overbend {

/// Returns tiles, figures and tables; empty without lines. `dynamics`: results of a run, or null.
Blocks lines_section(const StaticResults& statics, const DynamicResults* dynamics);

}  // namespace overbend
