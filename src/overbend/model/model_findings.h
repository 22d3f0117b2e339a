/// Findings on a model, independent of the analysis.
#pragma once

#include <string>
#include <vector>

#include "base/finding.h"
#include "model/model.h"

namespace overbend {

/// Returns warnings of the reader, RAOs that disagree with long-wave limits, and dynamic analyses without any motion:
/// plain sentences, the first part of the warnings of all results.
Findings model_findings(const Model& model);

}  // namespace overbend
