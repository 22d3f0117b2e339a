/// Results of a floating hull other than its pose.
#pragma once

#include <string>
#include <vector>

#include "base/assumption.h"
#include "base/finding.h"
#include "model/model.h"
#include "results/hull_results.h"
#include "results/mooring_results.h"

namespace overbend {

struct HullStatics {
  HullResults results;
  Assumptions assumptions;
  Findings findings;  ///< Full sentences.
};

/// Computes the account of a hull with hydrodynamic coefficients in the sea of the model; nullopt for other hulls.
/// `rest`: state on mooring lines, whose stiffness determines periods and damping ratios; null without lines. Fits the
/// radiation, which takes a fraction of a second. Throws std::invalid_argument for an invalid sea or hull.
std::optional<HullStatics> compute_hull_statics(const Model& model, const MooredState* rest);

/// Stiffness of the lines about the hull's centre of gravity, horizontal axes along the nominal heading; zero without
/// lines (null) or with a held hull [N/m, N, N m].
Mat6 station_stiffness(const MooredState* rest, const Vec3& centre_of_gravity);

}  // namespace overbend
