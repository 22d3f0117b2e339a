/// The variants of a model that are compared.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/description/description.h"
#include "results/comparison_results.h"
#include "study/run/case.h"

namespace overbend {

/// Each a key of the model file set to another value.
std::vector<Case> variants_of(ComparisonOf of);

/// Why the model cannot be compared so; nothing when it can.
std::optional<std::string> comparison_obstacle(ComparisonOf of, const Description& description);

}  // namespace overbend
