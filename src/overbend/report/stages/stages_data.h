/// Data for the figures of an operation on the line.
#pragma once

#include <optional>

#include "base/json.h"
#include "model/description/description.h"
#include "results/operation_results.h"

namespace overbend {

/// Returns JSON under "stages": shape of the line at each stage with its division into pipe, head and cable, results
/// over the stages, limits, and surrounding objects. SI unless a unit is given; positions as in report_data.h.
Json stages_data(const OperationResults& results, const std::optional<Description>& description);

}  // namespace overbend
