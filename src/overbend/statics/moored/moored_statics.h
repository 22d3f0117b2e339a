/// Results of a hull and its mooring lines at rest.
#pragma once

#include <variant>

#include "model/model.h"
#include "results/mooring_results.h"
#include "statics/moored/moored_rest.h"
#include "statics/moored/pull_ahead.h"

namespace overbend {

/// Results of a hull with what is assumed and found of it.
struct MooredOutcome {
  MooringResults results;
  Assumptions assumptions;
  Findings findings;
};

/// Of a hull whose rest at the start has been found, the stages of its operation included; or why there are none.
/// `pipe`: of a lay.
std::variant<MooredOutcome, StaticFailure> moored_results(const Model& model, const MooredHull& moored,
                                                          const PipeOnHull& pipe = {});

}  // namespace overbend
