/// Variants of a model for a comparison.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/description/description.h"
#include "results/comparison_results.h"
#include "study/run/case.h"

namespace overbend {

/// Returns one case per variant, each with one key of the model file changed.
std::vector<Case> make_variants(ComparisonType of);

/// Returns the reason that the model does not support the comparison; empty if it does.
std::optional<std::string> unsupported_comparison(ComparisonType of, const Description& description);

}  // namespace overbend
