/// What is told of a structure that passes over the supports.
#pragma once

#include "report/page/blocks.h"
#include "results/passage_results.h"

namespace overbend {

/// The largest of every box over the passage, and of the pipe beside the structure.
Blocks passage_section(const PassageResults& passage);

}  // namespace overbend
