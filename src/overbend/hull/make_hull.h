/// The hull of a model: coefficients, sea and environment combined.
#pragma once

#include <string>
#include <vector>

#include "base/finding.h"
#include "hull/hull.h"
#include "hull/make_radiation.h"
#include "model/model.h"

namespace overbend {

/// A hull with its diagnostics.
struct MadeHull {
  Hull hull;
  RadiationReport radiation;  ///< Accuracy of the radiation memory; empty without hydrodynamic data.
  Findings findings;          ///< Warnings as sentences.
};

/// Returns the box of the vessel's dimensions with the displaced volume of the hull's mass.
UfcHull ufc_hull(const Model& model, const CoupledHullDescription& description);

/// Returns the hull in current, wind and sea, without rigid body and radiation memory: sufficient for steady_forces.
/// Without hydrodynamic data there are no wave forces. Throws std::invalid_argument for a table without rows or axes,
/// and for wave directions outside the data.
Hull make_hull_in_environment(const Model& model, const CoupledHullDescription& description, const Sea& sea);

/// Returns the hull of a model for statics, without radiation memory and damping, from `vessel.motion.coupled` or
/// `vessel.hydrostatics`. Of the waves only the mean drift acts. Throws as make_hull().
Hull make_hull_at_rest(const Model& model, const Sea& sea);

/// Returns the hull of `vessel.motion.coupled`, or of `vessel.hydrostatics` (statics only), in the model's nominal pose
/// in a sea. `station_stiffness`: restoring stiffness for damping given as a ratio of critical in surge, sway or yaw.
/// Waves and drift are ramped up over the build-up [s]. Ballast is zero. Throws std::invalid_argument for an invalid
/// description: missing data, a current without current coefficients, a damping ratio without stiffness.
MadeHull make_hull(const Model& model, const Sea& sea, double build_up, const Mat6& station_stiffness = Mat6::Zero());

}  // namespace overbend
