/// What is told of a floating hull beside where it lies.
#pragma once

#include <string>
#include <vector>

#include "base/assumption.h"
#include "base/finding.h"
#include "model/model.h"
#include "results/hull_results.h"
#include "results/mooring_results.h"

namespace overbend {

struct HullAccount {
  HullResults results;
  Assumptions assumptions;
  Findings findings;  ///< Plain sentences.
};

/// Of a hull with hydrodynamic coefficients, in the sea of the model; nullopt for others. `rest`: on mooring lines,
/// whose stiffness decides periods and damping ratios; null without. Fits the radiation, which takes a part of a
/// second. Throws std::invalid_argument for a sea or a hull that cannot be made.
std::optional<HullAccount> hull_account(const Model& model, const MooredState* rest);

/// Of the lines about the hull's centre of gravity, horizontal axes along the drawn hull; zero without lines (null) or
/// with a hull that is held [N/m, N, N m].
Mat6 station_stiffness(const MooredState* rest, const Vec3& centre_of_gravity);

}  // namespace overbend
