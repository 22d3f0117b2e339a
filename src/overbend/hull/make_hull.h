/// The hull of a model: coefficients, sea and environment put together.
#pragma once

#include <string>
#include <vector>

#include "base/finding.h"
#include "hull/hull.h"
#include "hull/make_radiation.h"
#include "model/model.h"

namespace overbend {

struct MadeHull {
  Hull hull;
  RadiationReport radiation;  ///< Quality of the memory; empty without hydrodynamic data.
  Findings findings;          ///< Plain sentences.
};

/// The box of the vessel's dimensions with the water that the hull's mass displaces.
UfcHull ufc_hull(const Model& model, const CoupledHullDescription& given);

/// The hull in current, wind and sea, without a body and without the memory of radiated waves: enough for
/// steady_forces. Without hydrodynamic data there are no forces of waves. Throws std::invalid_argument for a table
/// without rows or axes, and for waves from where the data have no forces.
Hull hull_in_surroundings(const Model& model, const CoupledHullDescription& given, const Sea& sea);

/// The hull of a model at rest, without the memory of radiated waves and without damping: of `vessel.motion.coupled` or
/// of `vessel.hydrostatics`. Of the sea its mean drift acts. Throws as make_hull().
Hull make_hull_at_rest(const Model& model, const Sea& sea);

/// The hull of `vessel.motion.coupled`, or of `vessel.hydrostatics` (statics alone), as drawn by the model, in a sea.
/// `station_stiffness`: of what keeps the hull's place, for damping given as a ratio of critical in surge, sway or yaw.
/// The build-up [s] brings in waves and drift. Ballast is left zero. Throws std::invalid_argument for a description
/// that cannot be followed: no data read, a current without a word on the hull's current forces, a ratio of critical
/// without stiffness.
MadeHull make_hull(const Model& model, const Sea& sea, double build_up, const Mat6& station_stiffness = Mat6::Zero());

}  // namespace overbend
