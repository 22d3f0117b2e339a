/// Texts and tables of a comparison; empty without content.
#pragma once

#include "report/page/blocks.h"
#include "results/comparison_results.h"

namespace overbend {

/// Returns the interpretation of the differences, in sentences.
Blocks comparison_section(const Comparison& comparison);

/// Returns a table with a row per roller box.
Blocks boxes_section(const Comparison& comparison);

}  // namespace overbend
