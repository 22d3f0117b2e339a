/// Text and tables of a comparison. Each returns HTML; empty where there is nothing to say.
#pragma once

#include <string>

#include "results/comparison_results.h"

namespace overbend {

/// Interpretation of the differences, in sentences.
std::string comparison_section(const Comparison& comparison);

/// A row per support box.
std::string boxes_section(const Comparison& comparison);

}  // namespace overbend
