#include "report/studies/seek_section.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/units.h"
#include "report/studies/seek_texts.h"

namespace overbend {
namespace {

Table unknown_table(const SeekResults& seek) {
  Table table{
      "Keys of the model",
      {TableColumn("Key"), TableColumn::texts("Model"), TableColumn::texts("Answer"), TableColumn::texts("Bounds")},
      "summary"};
  for (const SeekUnknown& u : seek.unknowns) {
    table.row({u.name, quantity_text(u.before, u), quantity_text(u.answer, u),
               quantity_text(u.from, u) + " to " + quantity_text(u.to, u)},
              u.at_bound ? RowMark::over : RowMark::none);
  }
  return table;
}

/// Change of the result per change of the key, in the display units of both.
std::string slope_text(const SeekResults& seek, const SeekGoal& goal) {
  if (goal.slope.size() != 1) return "-";
  const SeekUnknown& u = seek.unknowns.front();
  const std::string unit = key_unit(u);
  const double per = unit.empty() ? 1.0 : unit_factor(unit, u.unit).value_or(1.0);
  return goal_value_text(goal.slope.front() * per, goal, 4) + (unit.empty() ? "" : " per " + unit);
}

Table goal_table(const SeekResults& seek) {
  Table table{"Goals",
              {TableColumn("Result"), TableColumn::texts("Wanted"), TableColumn::texts("Model"),
               TableColumn::texts("With the answer"), TableColumn::texts("Slope")},
              "summary"};
  for (const SeekGoal& goal : seek.goals) {
    table.row({goal.result, goal_text(goal), goal.before ? goal_value_text(*goal.before, goal) : "-",
               goal.reached ? goal_value_text(*goal.reached, goal) : "-", slope_text(seek, goal)});
  }
  return table;
}

Table jump_table(const SeekResults& seek) {
  Table table{"Jumps across the target",
              {TableColumn::texts(seek.unknowns.front().name), TableColumn::texts("Below"), TableColumn::texts("Above"),
               TableColumn("What changes")}};
  for (const SeekJump& jump : seek.jumps) {
    table.row({quantity_text(jump.key_value, seek.unknowns.front()), goal_value_text(jump.below, seek.goals.front()),
               goal_value_text(jump.above, seek.goals.front()), jump.why});
  }
  return table;
}

Blocks remarks(const SeekResults& seek) {
  std::vector<std::string> sentences = seek.remarks;
  for (const double value : seek.others) {
    sentences.push_back("Another answer: " + quantity_text(value, seek.unknowns.front()));
  }
  return block::list(sentences) +
         block::remark(fmt::format(
             "{} models were solved in {:.2f} s; the largest error of a condition is {:.1e} of the target. The "
             "report below is for the model with the answer applied.",
             seek.evaluations, seek.wall_time, seek.residual));
}

/// The stages changed by the answer, to be copied into a model.
Blocks stage_texts(const SeekResults& seek) {
  Blocks texts;
  for (const std::string& stage : seek.stages) texts += block::verbatim(stage);
  return texts;
}

/// A panel for each of the first goals.
Blocks path_figure(const SeekResults& seek) {
  constexpr std::size_t kMaxPanels = 6;
  Figure figure{"seek_path",
                seek.unknowns.size() == 1
                    ? "Models solved in the search: the result over the key. The horizontal line is the target."
                    : "The goals at each step of the search. The horizontal line is the target.",
                {}};
  for (std::size_t i = 0; i < std::min(seek.goals.size(), kMaxPanels); ++i) figure.parts.push_back(std::to_string(i));
  return block::figure(figure);
}

Json shown_in(const std::string& name, const std::string& unit, const std::string& show) {
  const double factor = show.empty() ? 1.0 : unit_factor(show, unit).value_or(1.0);
  return {{"name", name}, {"unit", show}, {"factor", 1.0 / factor}};
}

Json goal_data(const SeekGoal& goal) {
  Json data = shown_in(goal.result, goal.unit, goal_unit(goal));
  data["wanted"] = goal.is ? Json(goal.wanted) : Json(nullptr);
  data["reached"] = goal.reached ? Json(*goal.reached) : Json(nullptr);
  return data;
}

}  // namespace

Blocks seek_section(const SeekResults& seek) {
  return block::section("seek", "Goal seek",
                        unknown_table(seek) + goal_table(seek) + stage_texts(seek) + jump_table(seek) + remarks(seek) +
                            path_figure(seek));
}

Json seek_figure_data(const SeekResults& seek) {
  Json data;
  data["keys"] = Json::array();
  for (const SeekUnknown& u : seek.unknowns) {
    Json key = shown_in(u.name, u.unit, key_unit(u));
    key["answer"] = u.answer;
    data["keys"].push_back(key);
  }
  data["goals"] = Json::array();
  for (const SeekGoal& goal : seek.goals) data["goals"].push_back(goal_data(goal));
  data["path"] = Json::array();
  for (const SeekStep& step : seek.path) {
    if (!step.results.empty()) data["path"].push_back({{"values", step.values}, {"results", step.results}});
  }
  return data;
}

}  // namespace overbend
