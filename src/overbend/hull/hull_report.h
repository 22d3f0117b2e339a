/// What is told of a floating hull beside its results: how well its memory represents the file, what damps its slow
/// motions, and what was left out or assumed. Plain data for printing.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "base/assumption.h"
#include "base/finding.h"
#include "hull/damping_ratios.h"
#include "hull/make_hull.h"

namespace overbend {

struct HullReport {
  RadiationReport radiation;
  std::array<ModeDamping, 3> damping;           ///< Surge, sway, yaw; zero where nothing keeps the hull's place.
  double below_table = 0.0, above_table = 0.0;  ///< Share of the sea's variance beyond the wave forces' table [-].
  /// Sideways current force now, and for coefficients from that of UFC 4-159-03 for the barge's shape and depth of
  /// water to 1.2 (sharp edges in two dimensions) [N]; zero where the current is by a table or there is none.
  double current_now = 0.0, current_least = 0.0, current_most = 0.0;
  SteadyForces steady;  ///< With the hull as drawn, the mean drift included.
  Assumptions assumptions;
  Findings findings;  ///< Plain sentences.
};

/// `station_stiffness`: of the moorings about the reference point, horizontal axes along the drawn hull; `model` the
/// one that `made` is of, in `sea`.
HullReport hull_report(const MadeHull& made, const Model& model, const Sea& sea, const Mat6& station_stiffness);

}  // namespace overbend
