/// What is told of a floating hull beside where it lies.
#pragma once

#include <string>
#include <vector>

#include "model/model.h"
#include "results/hull_results.h"
#include "results/mooring_results.h"

namespace overbend {

struct HullAccount {
  HullResults results;
  std::vector<std::string> assumptions, warnings;  ///< Plain sentences.
};

/// Of a hull with hydrodynamic coefficients, in the sea of the model; nullopt for others. `rest`: on mooring lines,
/// whose stiffness decides periods and damping ratios; null without. Fits the radiation, which takes a part of a
/// second. Throws std::invalid_argument for a sea or a hull that cannot be made.
std::optional<HullAccount> hull_account(const Model& model, const MooredState* rest);

}  // namespace overbend
