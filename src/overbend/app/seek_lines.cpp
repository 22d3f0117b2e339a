#include "app/seek_lines.h"

#include <fmt/format.h>

#include "report/studies/seek_words.h"

namespace overbend {
namespace {

std::string line(const std::string& name, const std::string& value) {
  return fmt::format("  {:<44} {}\n", name, value);
}

std::string unknown_line(const SeekUnknown& unknown) {
  return line(unknown.name, fmt::format("{:>16}   (model: {})", quantity_words(unknown.answer, unknown, 7),
                                        quantity_words(unknown.before, unknown, 7)));
}

std::string goal_line(const SeekGoal& goal) {
  std::string value = goal.reached ? fmt::format("{:>16}", result_words(*goal.reached, goal)) : "";
  if (goal.is) value += "   (wanted: " + wanted_words(goal) + ")";
  if (!goal.is && goal.before) value += "   (model: " + result_words(*goal.before, goal) + ", minimised)";
  return line(goal.result, value);
}

}  // namespace

std::string seek_lines(const SeekResults& results) {
  std::string out;
  for (const SeekUnknown& unknown : results.unknowns) {
    if (results.found) out += unknown_line(unknown);
  }
  for (const SeekGoal& goal : results.goals) {
    if (results.found) out += goal_line(goal);
  }
  for (const double other : results.others) {
    out += line("another answer", fmt::format("{:>16}", quantity_words(other, results.unknowns.front(), 7)));
  }
  for (const SeekJump& jump : results.jumps) {
    const SeekGoal& goal = results.goals.front();
    out += line("a jump at " + quantity_words(jump.at, results.unknowns.front()),
                fmt::format("from {} to {}{}", result_words(jump.below, goal), result_words(jump.above, goal),
                            jump.why.empty() ? "" : ": " + jump.why));
  }
  out += line("search",
              fmt::format("{} models, {:.2f} s, {:.1e} off", results.evaluations, results.wall_time, results.residual));
  for (const std::string& remark : results.remarks) out += "  note: " + remark + "\n";
  return out;
}

}  // namespace overbend
