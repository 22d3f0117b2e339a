#include "model/description/operation_names.h"

#include <fmt/format.h>

#include "base/shown_unit.h"
#include "model/description/description_enum_names.h"

namespace overbend {

const char* operation_name(OperationType type) {
  return enum_name(type);
}

std::optional<OperationType> find_operation_type(const std::string& word) {
  return from_enum_name<OperationType>(word);
}

std::string stage_label(const LayStageDescription& stage, OperationType type) {
  std::string text = fmt::format("stage '{}' of the operation {}", stage.name, operation_name(type));
  if (stage.cable_out) text += fmt::format(": cable payout {}", shown_digits(*stage.cable_out, "m", 6));
  if (stage.pipe_out) text += fmt::format(": pipe payout {}", shown_digits(*stage.pipe_out, "m", 6));
  if (stage.ahead) text += fmt::format(": {} ahead", shown_digits(*stage.ahead, "m", 6));
  if (stage.passed) text += fmt::format(": {} from the tensioner", shown_digits(*stage.passed, "m", 6));
  if (stage.tank_weight) text += fmt::format(": tank weight {}", shown_digits(*stage.tank_weight, "N", 6));
  if (stage.tank_ballast) text += fmt::format(": tank flooded to {:.6g} %", 100.0 * *stage.tank_ballast);
  return text;
}

}  // namespace overbend
