/// Descriptions of the material law of the steel, for reports and `overbend check`.
#pragma once

#include <string>
#include <vector>

#include "base/assumption.h"
#include "base/finding.h"
#include "model/model.h"

namespace overbend {

/// Returns the law of a section's steel with its parameters and the accuracy of a fit: "Ramberg-Osgood in stress and
/// strain, n = 25, ...".
std::string material_law_label(const SteelDescription& steel);

/// Returns the assumptions on the steel of all sections.
Assumptions material_assumptions(const Model& model);

/// Returns warnings about moment-curvature curves with a poor fit.
Findings material_findings(const Model& model);

}  // namespace overbend
