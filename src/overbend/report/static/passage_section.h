/// Results of a structure that passes over the supports.
#pragma once

#include "report/page/blocks.h"
#include "results/passage_results.h"

namespace overbend {

/// Returns the maxima of every box during the passage, and of the pipe next to the structure.
Blocks passage_section(const PassageResults& passage);

}  // namespace overbend
