/// What the file wants, tension or anchor, beside what was found.
#pragma once

#include "model/model.h"
#include "results/static_results.h"
#include "statics/solver/statics.h"

namespace overbend {

/// Warns where the recovered forces and places miss what the file wants.
void warn_of_missed_target(StaticResults& results, const Model& model);

/// Derivative of the tension at the tensioner with respect to the distance of the anchor [N/m]; none where the tangent
/// is singular.
std::optional<double> tension_per_anchor_distance(const Model& model, const StaticSolution& solution);

/// Adds to the assumptions how much an error in pipe.length or pipe.anchor changes a tension that follows from them.
void note_sensitive_tension(StaticResults& results, const Model& model, const StaticSolution& solution);

}  // namespace overbend
