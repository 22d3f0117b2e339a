/// The table of code checks of a static state or of a dynamic run.
#pragma once

#include "model/model.h"
#include "results/dynamic_results.h"
#include "results/static_results.h"

namespace overbend {

/// Of the static state: stations must be set.
CheckTable check_statics(const Model& model, const StaticResults& statics);

/// Of a run: stations, envelopes and the design values must be set.
CheckTable check_dynamics(const Model& model, const StaticResults& statics, const DynamicResults& dynamics);

}  // namespace overbend
