/// Data of the figures of an operation on the line.
#pragma once

#include <optional>

#include "base/json.h"
#include "model/description/description.h"
#include "results/operation_results.h"

namespace overbend {

/// JSON under "stages": shape of the line at each stage with what of it is pipe, head and cable, results over the
/// stages, limits, and what stands around. SI but for what says its unit; places as in report_data.h.
Json stages_data(const OperationResults& results, const std::optional<Description>& description);

}  // namespace overbend
