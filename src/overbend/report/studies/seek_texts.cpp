#include "report/studies/seek_texts.h"

#include <fmt/format.h>

#include "base/units.h"
#include "report/page/quantity.h"

namespace overbend {

std::string key_unit(const SeekUnknown& unknown) {
  return unit_of_key(unknown.unit, unknown.show);
}

std::string goal_unit(const SeekGoal& goal) {
  const std::vector<std::string> units = usual_units(goal.unit);
  return units.empty() || goal.unit == "1" ? "" : unit_of_key(goal.unit, units.front());
}

std::string quantity_text(double value, const SeekUnknown& unknown, int digits) {
  const std::string unit = key_unit(unknown);
  return unit.empty() ? format_number(value, digits) : format_quantity(value, unknown.unit, unit, digits);
}

std::string goal_value_text(double value, const SeekGoal& goal, int digits) {
  const std::string unit = goal_unit(goal);
  return unit.empty() ? format_number(value, digits) : format_quantity(value, goal.unit, unit, digits);
}

std::string goal_text(const SeekGoal& goal) {
  if (!goal.is) return "least";
  std::string value = goal_value_text(goal.wanted, goal);
  switch (*goal.is) {
    case SeekRelation::at_most:
      return "at most " + value;
    case SeekRelation::at_least:
      return "at least " + value;
    case SeekRelation::equals:
      break;
  }
  return value;
}

std::string no_answer_reason(const SeekResults& results, const ScanSummary& labels) {
  const SeekUnknown& unknown = results.unknowns.front();
  const SeekGoal& goal = results.goals.front();
  std::string why =
      fmt::format("no {} between {} and {} makes {} {}", unknown.name, quantity_text(unknown.from, unknown),
                  quantity_text(unknown.to, unknown), goal.result, goal_text(goal));
  if (!labels.minimum) {
    why += labels.failure.empty() ? "; the result does not apply to this model" : "; no model has an equilibrium";
  } else {
    why += fmt::format("; it goes from {} to {}", goal_value_text(*labels.minimum, goal),
                       goal_value_text(*labels.maximum, goal));
  }
  for (const SeekJump& jump : results.jumps) {
    why += fmt::format("; at {} it jumps from {} to {}", quantity_text(jump.key_value, unknown),
                       goal_value_text(jump.below, goal), goal_value_text(jump.above, goal));
    if (!jump.why.empty()) why += " because " + jump.why;
  }
  if (labels.minimum && !labels.gaps.empty()) {
    why += fmt::format("; there is no equilibrium at {} of the values tried, from {} to {}", labels.gaps.size(),
                       quantity_text(labels.gaps.front(), unknown), quantity_text(labels.gaps.back(), unknown));
  }
  if (!labels.failure.empty()) why += " (" + labels.failure + ")";
  return why;
}

}  // namespace overbend
