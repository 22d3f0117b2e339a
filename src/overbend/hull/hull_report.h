/// Diagnostics of the hull model: accuracy of the radiation memory, damping of low-frequency motions, omissions and
/// assumptions. Plain data for printing.
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
  std::array<ModeDamping, 3> damping;           ///< Surge, sway, yaw; zero without a restraint.
  double below_table = 0.0, above_table = 0.0;  ///< Shares of the sea's variance outside the wave force table [-].
  /// Lateral current force with the model's coefficient, and for coefficients from that of UFC 4-159-03 for the barge's
  /// shape and water depth up to 1.2 (sharp edges in two dimensions) [N]; zero for a current by table or without a
  /// current.
  double model_current_force = 0.0, min_current_force = 0.0, max_current_force = 0.0;
  SteadyForces steady;  ///< In the nominal pose, including the mean drift.
  Assumptions assumptions;
  Findings findings;  ///< Warnings as sentences.
};

/// Returns the diagnostics. `station_stiffness`: of the moorings about the reference point, horizontal axes along the
/// nominal heading; `made` is the hull of `model` in `sea`.
HullReport hull_report(const MadeHull& made, const Model& model, const Sea& sea, const Mat6& station_stiffness);

}  // namespace overbend
