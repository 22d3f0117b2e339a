/// Limits of operability as JSON, for summary.json, the page and to be read again.
#pragma once

#include <nlohmann/json.hpp>

#include "results/study_results.h"

namespace overbend {

/// All that is known of a chart, in SI units. What does not apply is left out.
nlohmann::ordered_json operability_json(const OperabilityResults& results);

/// The same backwards. Throws nlohmann::json::exception where something is missing or of another kind.
OperabilityResults operability_of(const nlohmann::ordered_json& json);

}  // namespace overbend
