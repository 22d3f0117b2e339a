/// Limits of operability as JSON, for summary.json and the page, and their reader.
#pragma once

#include "base/json.h"
#include "results/study_results.h"

namespace overbend {

/// Returns all data of a chart in SI units. Values that do not apply are omitted.
Json operability_json(const OperabilityResults& results);

/// Reads them back. Throws Json::exception if a member is missing or of another type.
OperabilityResults operability_from_json(const Json& json);

}  // namespace overbend
