/// Statics of an anchor that is taken up and laid down elsewhere.
#pragma once

#include <string>
#include <vector>

#include "model/model.h"
#include "statics/moored/moored_rest.h"

namespace overbend {

/// The hull on its lines at one stage of the move.
struct AnchorStage {
  std::string name;
  MooredHull hull;
};

/// The stages, each with the hull at the rest it finds: the line slackened to the handling tension; without the line,
/// whose wire a tug holds; the anchor at its new place with the handling tension; the line hauled to its working
/// tension; where there is a test, with the tension of the test. Lengths of the other lines stand. The last one may
/// have a fault.
std::vector<AnchorStage> anchor_stages(const Model& model, const MooredHull& start);

}  // namespace overbend
