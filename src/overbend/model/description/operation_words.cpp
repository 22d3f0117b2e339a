#include "model/description/operation_words.h"

#include <fmt/format.h>

#include "base/shown_unit.h"
#include "model/description/description_words.h"

namespace overbend {

const char* operation_word(OperationType type) {
  return word_of(type);
}

std::optional<OperationType> operation_of_word(const std::string& word) {
  return from_word<OperationType>(word);
}

std::string stage_words(const LayStageDescription& stage, OperationType type) {
  std::string words = fmt::format("stage '{}' of the operation {}", stage.name, operation_word(type));
  if (stage.cable_out) words += fmt::format(": {} of cable out", shown_digits(*stage.cable_out, "m", 6));
  if (stage.pipe_out) words += fmt::format(": {} of pipe out", shown_digits(*stage.pipe_out, "m", 6));
  if (stage.ahead) words += fmt::format(": {} ahead", shown_digits(*stage.ahead, "m", 6));
  if (stage.passed) words += fmt::format(": {} from the tensioner", shown_digits(*stage.passed, "m", 6));
  if (stage.tank_weight) words += fmt::format(": a tank of {}", shown_digits(*stage.tank_weight, "N", 6));
  if (stage.tank_ballast) words += fmt::format(": a tank flooded to {:.6g} %", 100.0 * *stage.tank_ballast);
  return words;
}

}  // namespace overbend
