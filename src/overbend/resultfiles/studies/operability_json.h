/// Limits of operability as JSON, for summary.json, the page and to be read again.
#pragma once

#include "base/json.h"
#include "results/study_results.h"

namespace overbend {

/// All that is known of a chart, in SI units. What does not apply is left out.
Json operability_json(const OperabilityResults& results);

/// The same backwards. Throws Json::exception where something is missing or of another kind.
OperabilityResults operability_of(const Json& json);

}  // namespace overbend
