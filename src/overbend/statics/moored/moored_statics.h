/// Results of a hull and its mooring lines at rest.
#pragma once

#include <variant>

#include "model/model.h"
#include "results/mooring_results.h"
#include "statics/moored/moored_rest.h"
#include "statics/moored/pull_ahead.h"

namespace overbend {

/// Whether the model's statics are those of a hull and its lines.
bool is_moored_hull(const Description& description);

/// Results of a hull whose rest at the start has been found, the stages of its operation included; or why there are
/// none. `pipe`: of a lay.
std::variant<MooringResults, StaticFailure> moored_results(const Model& model, const MooredHull& moored,
                                                           const PipeOnHull& pipe = {});

}  // namespace overbend
