/// From bodies at rest to what is told of them.
#pragma once

#include "model/model.h"
#include "results/body_results.h"
#include "system/assembly.h"

namespace overbend {

/// Of the bodies of the model besides the vessel, and of the vessel itself where it floats free. `assembly` stands
/// evaluated at `state`.
std::vector<BodyResult> recover_bodies(const Model& model, const Assembly& assembly, const SystemState& state);

}  // namespace overbend
