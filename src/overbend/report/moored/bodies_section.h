/// Bodies connected to lines: poses, motions and loads of the lines.
#pragma once

#include "report/page/blocks.h"
#include "results/dynamic_results.h"

namespace overbend {

/// Returns the section; empty without bodies. `dynamics`: results of a run, or null.
Blocks bodies_section(const StaticResults& statics, const DynamicResults* dynamics);

}  // namespace overbend
