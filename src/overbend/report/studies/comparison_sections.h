/// Text and tables of a comparison; empty where there is nothing to say.
#pragma once

#include "report/page/blocks.h"
#include "results/comparison_results.h"

namespace overbend {

/// Interpretation of the differences, in sentences.
Blocks comparison_section(const Comparison& comparison);

/// A row per support box.
Blocks boxes_section(const Comparison& comparison);

}  // namespace overbend
