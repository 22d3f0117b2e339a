/// What a comparison says in words and tables. Each returns HTML; empty where there is nothing to say.
#pragma once

#include <string>

#include "results/comparison_results.h"

namespace overbend {

/// What the difference means, in sentences.
std::string findings_section(const Comparison& comparison);

/// A row per support box.
std::string boxes_section(const Comparison& comparison);

}  // namespace overbend
