/// What is told of a structure that passes over the supports.
#pragma once

#include <string>

#include "results/passage_results.h"

namespace overbend {

/// HTML: the largest of every box over the passage, and of the pipe beside the structure.
std::string passage_section(const PassageResults& passage);

}  // namespace overbend
