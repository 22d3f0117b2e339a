/// Comparison of the specified tension or anchor distance with the result.
#pragma once

#include "model/model.h"
#include "results/static_results.h"
#include "statics/solver/statics.h"

namespace overbend {

/// Warns if the recovered forces and positions miss the specified ones.
void warn_of_missed_target(StaticResults& results, const Model& model);

/// Derivative of the tension at the tensioner with respect to the distance of the anchor [N/m]; nullopt if the tangent
/// is singular.
std::optional<double> tension_per_anchor_distance(const Model& model, const StaticSolution& solution);

/// Adds to the assumptions the effect of an error in pipe.length or pipe.anchor on a tension that follows from them.
void note_sensitive_tension(StaticResults& results, const Model& model, const StaticSolution& solution);

}  // namespace overbend
