/// A vessel that floats free and is held by lines that stand by themselves: at rest.
#pragma once

#include "statics/solver/lines_setup.h"
#include "statics/solver/statics.h"

namespace overbend {

/// Makes the vessel of lines a body that floats free, still held where it is as drawn. Nothing where statics hold it.
/// Throws std::invalid_argument for a hull that cannot be made.
void float_vessel(const Model& model, LinesSetup& setup);

/// What a vessel that floats is held by, all that acts on it together.
struct HeldVessel {
  std::optional<StaticFailure> failure;
  Mat6 stiffness =
      Mat6::Zero();  ///< Of lines about the centre of gravity, horizontal axes along the hull [N/m, N, N m].
};

/// Whether lines and water hold a vessel that has been let go, against small moves in every direction.
HeldVessel find_what_holds_vessel(const Model& model, const LinesSetup& setup, const SystemState& state);

/// Lets the vessel of lines at rest go: it is ballasted, where the model says so, for draught, heel and trim to stay,
/// and comes to rest with the lines. Where they are slack as drawn, soft springs hold it on its way to where they are
/// not; none is left in the end. Says by name in which directions nothing holds it.
HeldVessel let_vessel_float(const Model& model, LinesSetup& setup, SystemState& state);

}  // namespace overbend
