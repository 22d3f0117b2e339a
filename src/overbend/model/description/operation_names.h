/// Names of the operation types, for code that has enumeration texts of its own.
#pragma once

#include <optional>
#include <string>

#include "model/description/mooring_description.h"

namespace overbend {

/// Returns the name in the model file, such as "abandonment".
const char* operation_name(OperationType type);
/// Returns the operation type with this name; empty if there is none.
std::optional<OperationType> find_operation_type(const std::string& word);

/// Returns a description such as "stage 'stage 3' of the operation abandonment: cable payout 190 m".
std::string stage_label(const LayStageDescription& stage, OperationType type);

}  // namespace overbend
