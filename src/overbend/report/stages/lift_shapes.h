/// The side view of a lift: all lines at every stage, attachments, water level and seabed.
#pragma once

#include <optional>
#include <string>

#include "model/description/description.h"
#include "results/operation_results.h"

namespace overbend {

/// HTML of the figure; empty where no stage stands. `figure` counts the figures of the page.
std::string lift_side_view(const OperationResults& results, const std::optional<Description>& description, int& figure);

}  // namespace overbend
