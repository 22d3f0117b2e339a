#include "model/description/operation_words.h"

#include <fmt/format.h>

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
  if (stage.cable_out) words += fmt::format(": {:.6g} m of cable out", *stage.cable_out);
  if (stage.pipe_out) words += fmt::format(": {:.6g} m of pipe out", *stage.pipe_out);
  if (stage.ahead) words += fmt::format(": {:.6g} m ahead", *stage.ahead);
  if (stage.passed) words += fmt::format(": {:.6g} m from the tensioner", *stage.passed);
  if (stage.tank_weight) words += fmt::format(": a tank of {:.6g} kN", 1e-3 * *stage.tank_weight);
  if (stage.tank_ballast) words += fmt::format(": a tank flooded to {:.6g} %", 100.0 * *stage.tank_ballast);
  return words;
}

}  // namespace overbend
