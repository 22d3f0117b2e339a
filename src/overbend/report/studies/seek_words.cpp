#include "report/studies/seek_words.h"

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

std::string quantity_words(double value, const SeekUnknown& unknown, int digits) {
  const std::string unit = key_unit(unknown);
  return unit.empty() ? format_number(value, digits) : format_quantity(value, unknown.unit, unit, digits);
}

std::string result_words(double value, const SeekGoal& goal, int digits) {
  const std::string unit = goal_unit(goal);
  return unit.empty() ? format_number(value, digits) : format_quantity(value, goal.unit, unit, digits);
}

std::string wanted_words(const SeekGoal& goal) {
  if (!goal.is) return "least";
  std::string value = result_words(goal.wanted, goal);
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

std::string why_none(const SeekResults& results, const ScanWords& words) {
  const SeekUnknown& unknown = results.unknowns.front();
  const SeekGoal& goal = results.goals.front();
  std::string why =
      fmt::format("no {} between {} and {} makes {} {}", unknown.name, quantity_words(unknown.from, unknown),
                  quantity_words(unknown.to, unknown), goal.result, wanted_words(goal));
  if (!words.least) {
    why += words.failure.empty() ? "; the result does not apply to this model" : "; no model has an equilibrium";
  } else {
    why += fmt::format("; it goes from {} to {}", result_words(*words.least, goal), result_words(*words.largest, goal));
  }
  for (const SeekJump& jump : results.jumps) {
    why += fmt::format("; at {} it jumps from {} to {}", quantity_words(jump.at, unknown),
                       result_words(jump.below, goal), result_words(jump.above, goal));
    if (!jump.why.empty()) why += " because " + jump.why;
  }
  if (words.least && !words.gaps.empty()) {
    why += fmt::format("; there is no equilibrium at {} of the values tried, from {} to {}", words.gaps.size(),
                       quantity_words(words.gaps.front(), unknown), quantity_words(words.gaps.back(), unknown));
  }
  if (!words.failure.empty()) why += " (" + words.failure + ")";
  return why;
}

}  // namespace overbend
