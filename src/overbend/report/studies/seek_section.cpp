#include "report/studies/seek_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/units.h"
#include "report/page/figure_list.h"
#include "report/page/html.h"
#include "report/studies/seek_words.h"

namespace overbend {
namespace {

constexpr std::array<const char*, 6> kParts = {"0", "1", "2", "3", "4", "5"};  // goals with a panel

std::string unknown_table(const SeekResults& seek) {
  html::Table table("Keys of the model", {{"Key", "", true}, {"Model", ""}, {"Answer", ""}, {"Bounds", ""}}, "summary");
  for (const SeekUnknown& u : seek.unknowns) {
    table.row({u.name, quantity_words(u.before, u), quantity_words(u.answer, u),
               quantity_words(u.from, u) + " to " + quantity_words(u.to, u)},
              u.at_bound ? "over" : "");
  }
  return table.str();
}

/// A change of the result for a change of the key, in the units that both are shown in.
std::string slope_words(const SeekResults& seek, const SeekGoal& goal) {
  if (goal.slope.size() != 1) return "-";
  const SeekUnknown& u = seek.unknowns.front();
  const std::string unit = key_unit(u);
  const double per = unit.empty() ? 1.0 : unit_factor(unit, u.unit).value_or(1.0);
  return result_words(goal.slope.front() * per, goal, 4) + (unit.empty() ? "" : " per " + unit);
}

std::string goal_table(const SeekResults& seek) {
  html::Table table("Results asked for",
                    {{"Result", "", true}, {"Wanted", ""}, {"Model", ""}, {"With the answer", ""}, {"Slope", ""}},
                    "summary");
  for (const SeekGoal& goal : seek.goals) {
    table.row({goal.result, wanted_words(goal), goal.before ? result_words(*goal.before, goal) : "-",
               goal.reached ? result_words(*goal.reached, goal) : "-", slope_words(seek, goal)});
  }
  return table.str();
}

std::string jump_table(const SeekResults& seek) {
  if (seek.jumps.empty()) return "";
  html::Table table("Jumps over the value wanted",
                    {{seek.unknowns.front().name, ""}, {"Below", ""}, {"Above", ""}, {"What changes", "", true}},
                    "plain");
  for (const SeekJump& jump : seek.jumps) {
    table.row({quantity_words(jump.at, seek.unknowns.front()), result_words(jump.below, seek.goals.front()),
               result_words(jump.above, seek.goals.front()), jump.why});
  }
  return table.str();
}

std::string remarks(const SeekResults& seek) {
  std::vector<std::string> sentences = seek.remarks;
  for (const double other : seek.others) {
    sentences.push_back("Another answer: " + quantity_words(other, seek.unknowns.front()));
  }
  std::string out = sentences.empty() ? "" : html::list(sentences);
  out += fmt::format(
      "<p class=\"small\">{} models were solved in {:.2f} s; the largest distance from a condition is "
      "{:.1e} of the value wanted. The report below is that of the model with the answer put in.</p>\n",
      seek.evaluations, seek.wall_time, seek.residual);
  return out;
}

/// The stages that the answer changes, to be copied into a model.
std::string stage_texts(const SeekResults& seek) {
  std::string text;
  for (const std::string& stage : seek.stages) text += "<pre>" + html::escape(stage) + "</pre>\n";
  return text;
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

std::string seek_section(const SeekResults& seek, int& figure) {
  const std::vector<Figure> figures = {
      {"seek_path",
       seek.unknowns.size() == 1
           ? "Models solved in the search: the result over the key. The horizontal line is the value wanted."
           : "The results asked for at each step of the search. The horizontal line is the value wanted.",
       {kParts.begin(), kParts.begin() + static_cast<std::ptrdiff_t>(std::min(seek.goals.size(), kParts.size()))}}};
  const std::string drawn = figure_list(
      figures, [](const Figure&, const std::string&) { return true; }, figure);
  return html::section(
      "seek", "Goal seek",
      unknown_table(seek) + goal_table(seek) + stage_texts(seek) + jump_table(seek) + remarks(seek) + drawn);
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
