#include "app/print_operability.h"

#include <fmt/format.h>

#include "base/units.h"
#include "resultfiles/studies/operability_table.h"

namespace overbend {
namespace {

const char* outcome_label(TrialStatus end) {
  switch (end) {
    case TrialStatus::passed:
      return "passed";
    case TrialStatus::exceeded:
      return "exceeded";
    case TrialStatus::no_solution:
      return "no solution";
    case TrialStatus::open:
      break;
  }
  return "open";
}

std::string limit_text(const OperabilityResults& results, const OperabilityCell& cell) {
  const auto shown = [&](double value) {
    return results.show.empty() ? format_number(value, 4) : format_quantity(value, results.unit, results.show, 4);
  };
  if (!cell.decided) return "?";
  if (!cell.limit) return "< " + shown(results.min_value);
  return (cell.beyond ? ">= " : "") + shown(*cell.limit);
}

}  // namespace

std::string trial_line(const OperabilityPlan& plan, const TrialReport& trial) {
  const CaseInput question = plan.question(trial.cell, trial.value, trial.seed);
  std::string line;
  for (const KeySetting& setting : question.keys) line += fmt::format("{} = {}, ", setting.key, setting.value);
  if (question.seed) line += fmt::format("seed {}, ", *question.seed);
  line.resize(line.size() - 2);
  line += fmt::format(": {}", outcome_label(trial.result.end));
  if (trial.result.utilisation) line += fmt::format(", {:.3f}", *trial.result.utilisation);
  if (!trial.result.governing.empty()) line += " " + trial.result.governing;
  return line + fmt::format(" ({:.1f} s)\n", trial.wall_time);
}

std::string limits_to_search(const OperabilityPlan& plan) {
  std::string axes;
  for (const StudyInput& axis : plan.axes()) {
    axes += fmt::format("{}{}{} of {}", axes.empty() ? " (" : " x ", axis.value_texts.size(),
                        axes.empty() ? " values" : "", axis.key);
  }
  const std::size_t cells = plan.cells(), seeds = plan.seeds().size();
  const std::string with = seeds > 1 ? fmt::format(", {} seeds each: {} searches", seeds, cells * seeds) : "";
  return fmt::format("{} limit{} to search{}{}{}", cells, cells == 1 ? "" : "s", axes, axes.empty() ? "" : ")", with);
}

std::string search_line(const OperabilityPlan& plan) {
  const auto shown = [&](double value) {
    const std::string& unit = plan.over().show;
    return unit.empty() ? format_number(value, 4) : format_quantity(value, plan.over().unit, unit, 4);
  };
  return fmt::format("  each limit is one of {} values of {} from {} to {}\n", plan.values().size(), plan.over().key,
                     shown(plan.values().front()), shown(plan.values().back()));
}

std::string operability_lines(const OperabilityResults& results) {
  std::string text =
      fmt::format("Limiting {} ({} analyses, {:.0f} s in total)\n", results.over, results.runs, results.wall_time);
  for (const OperabilityCell& cell : results.cells) {
    std::string place;
    for (std::size_t i = 0; i < results.axes.size(); ++i) {
      place += fmt::format("{}{} = {}", i == 0 ? "" : ", ", results.axes[i].key,
                           results.axes[i].value_texts.at(cell.value_indices[i]));
    }
    text += fmt::format("  {:<60} {:>10}  {}\n", place, limit_text(results, cell),
                        cell.decided ? cell.governing : cell.reason);
    if (cell.decided && !cell.reason.empty()) text += "      " + cell.reason + "\n";
  }
  if (results.workability) text += fmt::format("Workability {:.1f} % of the year\n", 100.0 * results.workability->year);
  for (const std::string& remark : results.remarks) text += "  note: " + remark + "\n";
  return text;
}

}  // namespace overbend
