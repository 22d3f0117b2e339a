/// The words of the types of operation, for rooms that have words of their own.
#pragma once

#include <optional>
#include <string>

#include "model/description/mooring_description.h"

namespace overbend {

/// "abandonment", as in the model file.
const char* operation_word(OperationType type);
/// None where it is no such word.
std::optional<OperationType> operation_of_word(const std::string& word);

/// "stage 'stage 3' of the operation abandonment: 190 m of cable out".
std::string stage_words(const LayStageDescription& stage, OperationType type);

}  // namespace overbend
