/// The law of the steel in words, for reports and `overbend check`.
#pragma once

#include <string>
#include <vector>

#include "base/assumption.h"
#include "base/finding.h"
#include "model/model.h"

namespace overbend {

/// "Ramberg-Osgood in stress and strain, n = 25, ...": the law of a section's steel with its numbers, a fit included.
std::string material_words(const SteelDescription& steel);

/// Assumptions on the steel of all sections.
Assumptions material_assumptions(const Model& model);

/// Warnings about moment-curvature curves that the model reproduces only roughly.
Findings material_findings(const Model& model);

}  // namespace overbend
