/// Statics of an anchor that is recovered and laid at a new position.
#pragma once

#include <string>
#include <vector>

#include "model/model.h"
#include "statics/moored/moored_equilibrium.h"

namespace overbend {

/// Equilibrium of the hull at one stage of the move.
struct AnchorStage {
  std::string name;
  MooredHull hull;
};

/// Stages, each with the hull in equilibrium: line slackened to the handling tension; line removed, its wire held by a
/// tug; anchor at its new position with the handling tension; line hauled to its working tension; optionally line at
/// the test tension. Lengths of the other lines are constant. The last stage may have an error.
std::vector<AnchorStage> anchor_stages(const Model& model, const MooredHull& start);

}  // namespace overbend
