/// Results of a hull and its mooring lines in static equilibrium.
#pragma once

#include <variant>

#include "model/model.h"
#include "results/mooring_results.h"
#include "statics/moored/moored_equilibrium.h"
#include "statics/moored/pull_ahead.h"

namespace overbend {

/// Results of a hull with its assumptions and findings.
struct MooredOutcome {
  MooringResults results;
  Assumptions assumptions;
  Findings findings;
};

/// Computes the results of a hull whose initial equilibrium has been found, including the stages of its operation; or
/// the failure. `pipe`: of a lay.
std::variant<MooredOutcome, StaticFailure> moored_results(const Model& model, const MooredHull& moored,
                                                          const PipeOnHull& pipe = {});

}  // namespace overbend
