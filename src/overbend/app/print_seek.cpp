#include "app/print_seek.h"

#include <fmt/format.h>

#include <algorithm>

#include "report/studies/seek_texts.h"

namespace overbend {
namespace {

constexpr std::size_t kNameWidth = 44;

std::string line(const std::string& name, const std::string& value, std::size_t width = kNameWidth) {
  return fmt::format("  {:<{}} {}\n", name, width, value);
}

/// Returns the width of the longest name of a key or result.
std::size_t name_width(const SeekResults& results) {
  std::size_t width = kNameWidth;
  for (const SeekUnknown& unknown : results.unknowns) width = std::max(width, unknown.name.size());
  for (const SeekGoal& goal : results.goals) width = std::max(width, goal.result.size());
  return width;
}

std::string unknown_line(const SeekUnknown& unknown, std::size_t width) {
  return line(unknown.name,
              fmt::format("{:>16}   (model: {})", quantity_text(unknown.answer, unknown, 7),
                          quantity_text(unknown.before, unknown, 7)),
              width);
}

std::string goal_line(const SeekGoal& goal, std::size_t width) {
  std::string value = goal.reached ? fmt::format("{:>16}", goal_value_text(*goal.reached, goal)) : "";
  if (goal.is) value += "   (target: " + goal_text(goal) + ")";
  if (!goal.is && goal.before) value += "   (model: " + goal_value_text(*goal.before, goal) + ", minimised)";
  return line(goal.result, value, width);
}

}  // namespace

std::string seek_lines(const SeekResults& results) {
  std::string out;
  const std::size_t width = name_width(results);
  for (const SeekUnknown& unknown : results.unknowns) {
    if (results.found) out += unknown_line(unknown, width);
  }
  for (const SeekGoal& goal : results.goals) {
    if (results.found) out += goal_line(goal, width);
  }
  if (!results.stages.empty()) out += "  solution (complete in model.yaml):\n";
  for (const std::string& stage : results.stages) out += "    " + stage + "\n";
  for (const double alternative : results.others) {
    out += line("another solution", fmt::format("{:>16}", quantity_text(alternative, results.unknowns.front(), 7)));
  }
  for (const SeekJump& jump : results.jumps) {
    const SeekGoal& goal = results.goals.front();
    out += line("jump at " + quantity_text(jump.key_value, results.unknowns.front()),
                fmt::format("from {} to {}{}", goal_value_text(jump.below, goal), goal_value_text(jump.above, goal),
                            jump.why.empty() ? "" : ": " + jump.why));
  }
  out += line("search", fmt::format("{} models, {:.2f} s, residual {:.1e}", results.evaluations, results.wall_time,
                                    results.residual));
  for (const std::string& remark : results.remarks) out += "  note: " + remark + "\n";
  return out;
}

}  // namespace overbend
