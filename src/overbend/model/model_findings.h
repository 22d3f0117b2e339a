/// What in a model calls for a second look, whatever is calculated with it.
#pragma once

#include <string>
#include <vector>

#include "base/finding.h"
#include "model/model.h"

namespace overbend {

/// Warnings of reading, RAOs that disagree with the water in long waves, a dynamic analysis in which nothing moves:
/// plain sentences, the first part of the warnings of all results.
Findings model_findings(const Model& model);

}  // namespace overbend
