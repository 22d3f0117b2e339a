/// Results of bodies in static equilibrium.
#pragma once

#include "model/model.h"
#include "results/body_results.h"
#include "system/assembly.h"

namespace overbend {

/// Results of the bodies of the model other than the vessel, and of the vessel itself if it floats freely. `assembly`
/// is evaluated at `state`.
std::vector<BodyResult> recover_bodies(const Model& model, const Assembly& assembly, const SystemState& state);

}  // namespace overbend
