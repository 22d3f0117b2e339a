/// Static equilibrium of a free-floating vessel held by lines only.
#pragma once

#include "statics/solver/lines_setup.h"
#include "statics/solver/statics.h"

namespace overbend {

/// Makes the vessel of lines a free body, held in its nominal pose for now. No effect if statics hold the vessel.
/// Throws std::invalid_argument for an invalid hull.
void float_vessel(const Model& model, LinesSetup& setup);

/// Stiffness that holds a free-floating vessel, and a failure if it is not held.
struct HeldVessel {
  std::optional<StaticFailure> failure;
  Mat6 stiffness =
      Mat6::Zero();  ///< Stiffness of lines about the centre of gravity, horizontal axes along the hull [N/m, N, N m].
};

/// Checks that lines and hydrostatics hold a released vessel against small motions in all directions.
HeldVessel find_vessel_stiffness(const Model& model, const LinesSetup& setup, const SystemState& state);

/// Releases the vessel of lines in equilibrium: ballasts it, if the model requires, to keep draught, heel and trim, and
/// finds the equilibrium with the lines. If the lines are slack in the nominal pose, soft springs hold the vessel
/// during the continuation; none remain at the end. Names the directions in which nothing holds it.
HeldVessel release_vessel(const Model& model, LinesSetup& setup, SystemState& state);

}  // namespace overbend
