#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/moored/moorings_section.h"
#include "report/page/figure_list.h"
#include "report/page/html.h"
#include "report/page/quantity.h"

namespace overbend {
namespace {

std::string signed_text(double value, std::string_view si, int digits) {
  const std::string text = shown_number(value, si, digits);
  return text.front() == '-' || std::stod(text) == 0.0 ? text : "+" + text;
}

std::vector<html::Head> line_heads(const MooringResults& results, std::vector<html::Head> head,
                                   const std::string& unit) {
  for (const MooringLineResult& line : results.rest.moorings) head.push_back({line.name, unit});
  return head;
}

bool has_lines(const MooringResults& results) {
  return !results.rest.moorings.empty();
}

std::string stage_table(const MooringResults& results) {
  std::vector<html::Head> head = {
      {"Stage", "", true}, {"Surge", shown_name("m")}, {"Sway", shown_name("m")}, {"Yaw", shown_name("rad")}};
  const bool positioned = !results.rest.thrust.empty();
  if (positioned) head.insert(head.end(), {{"Thrust ahead", shown_name("N")}, {"Thrust to port", shown_name("N")}});
  html::Table table(has_lines(results) ? "Offset of the vessel and tension at the fairleads" : "Offset of the vessel",
                    line_heads(results, head, shown_name("N")), "dense summary");
  const auto row = [&](const MooredState& state) {
    std::vector<std::string> cells = {state.name, shown_number(state.vessel.surge, "m", 3),
                                      shown_number(state.vessel.sway, "m", 3),
                                      shown_number(state.vessel.yaw, "rad", 3)};
    for (std::size_t i = 0; i < (positioned ? 2 : 0); ++i) cells.push_back(shown_number(state.thrust[i], "N", 1));
    bool over = false;
    for (const MooringLineResult& line : state.moorings) {
      cells.push_back(line.parted ? "parted" : shown_number(line.fairlead_tension, "N", 1));
      over = over || line.utilisation.value_or(0.0) > 1.0;
    }
    table.row(cells, over ? "over" : "");
  };
  row(results.rest);
  for (const MooredState& stage : results.stages) row(stage);
  return table.str();
}

std::string winch_table(const MooringResults& results) {
  if (results.winches.empty()) return "";
  html::Table table("Winches, from the first stage to the last",
                    {{"Line", "", true},
                     {"Paid out", shown_name("m")},
                     {"before", shown_name("m")},
                     {"after", shown_name("m")},
                     {"before", shown_name("N")},
                     {"after", shown_name("N")},
                     {"change", shown_name("N")}},
                    "plain");
  table.groups({{"", 2}, {"First segment", 2}, {"Tension at the fairlead", 3}});
  for (const WinchMove& move : results.winches) {
    table.row({move.name, signed_text(move.after - move.before, "m", 3), shown_number(move.before, "m", 3),
               shown_number(move.after, "m", 3), shown_number(move.tension_before, "N", 1),
               shown_number(move.tension_after, "N", 1),
               signed_text(move.tension_after - move.tension_before, "N", 1)});
  }
  return table.str() + "<p class=\"small\">Paid out: negative where the winch hauls in. The pull-ahead is " +
         shown(results.distance, "m", 2) + "; lengths are unstressed.</p>\n";
}

bool has_pipe(const MooringResults& results) {
  return !results.steps.empty() && std::all_of(results.steps.begin(), results.steps.end(),
                                               [](const MoveStep& step) { return step.pipe.has_value(); });
}

std::string pipe_table(const MooringResults& results) {
  if (!has_pipe(results)) return "";
  html::Table table("The pipe at the places of the pull-ahead",
                    {{"Advance", shown_name("m")},
                     {"top", shown_name("N")},
                     {"bottom", shown_name("N")},
                     {"stress", shown_name("Pa")},
                     {"strain", "%"},
                     {"stress", shown_name("Pa")},
                     {"strain", "%"},
                     {"Largest reaction", shown_name("N")},
                     {"at", "", true},
                     {"Lay-back", shown_name("m")},
                     {"Stinger tip clearance", shown_name("m")}},
                    "dense summary");
  table.groups({{"", 1}, {"Tension", 2}, {"Overbend, bending", 2}, {"Sagbend, bending", 2}, {"", 4}});
  for (const MoveStep& step : results.steps) {
    const PipeAtStep& pipe = *step.pipe;
    table.row({shown_number(step.advance, "m", 2), shown_number(pipe.top_tension, "N", 1),
               shown_number(pipe.bottom_tension, "N", 1), stresses().text(pipe.overbend_bending_stress, 1),
               strains().text(pipe.overbend_strain, 4), stresses().text(pipe.sagbend_bending_stress, 1),
               strains().text(pipe.sagbend_strain, 4), shown_number(pipe.largest_reaction, "N", 1),
               pipe.largest_reaction_support, shown_number(pipe.lay_back, "m", 2),
               pipe.stinger_tip_clearance ? shown_number(*pipe.stinger_tip_clearance, "m", 3) : "-"});
  }
  return table.str();
}

/// Long, and of interest to whoever sets the winches.
std::string step_tables(const MooringResults& results) {
  if (results.steps.empty() || !has_lines(results)) return "";
  html::Table lengths(
      "Unstressed length of the first segments",
      line_heads(results, {{"Advance", shown_name("m")}, {"Sway", shown_name("m")}, {"Yaw", shown_name("rad")}},
                 shown_name("m")),
      "dense summary");
  html::Table tensions("Tension at the fairleads", line_heads(results, {{"Advance", shown_name("m")}}, shown_name("N")),
                       "dense summary");
  for (const MoveStep& step : results.steps) {
    std::vector<std::string> length = {shown_number(step.advance, "m", 2), shown_number(step.vessel.sway, "m", 3),
                                       shown_number(step.vessel.yaw, "rad", 3)};
    std::vector<std::string> tension = {shown_number(step.advance, "m", 2)};
    for (const double value : step.lengths) length.push_back(shown_number(value, "m", 3));
    for (const double value : step.tensions) tension.push_back(shown_number(value, "N", 1));
    lengths.row(length);
    tensions.row(tension);
  }
  return html::folded(fmt::format("Lengths and tensions at {} places", results.steps.size()),
                      lengths.str() + tensions.str());
}

std::string anchor_table(const MooringResults& results) {
  if (results.anchors.empty()) return "";
  html::Table table("Anchors that are due on the route",
                    {{"Before joint", ""},
                     {"Line", "", true},
                     {"Reason", "", true},
                     {"east", shown_name("m")},
                     {"north", shown_name("m")},
                     {"east", shown_name("m")},
                     {"north", shown_name("m")},
                     {"Length", shown_name("m")}},
                    "plain");
  table.groups({{"", 3}, {"From", 2}, {"To", 2}, {"", 1}});
  for (const AnchorDue& due : results.anchors) {
    table.row({std::to_string(due.joint), due.line, due.reason, shown_number(due.from_W.x(), "m", 1),
               shown_number(due.from_W.y(), "m", 1), shown_number(due.to_W.x(), "m", 1),
               shown_number(due.to_W.y(), "m", 1), shown_number(due.length, "m", 2)});
  }
  return table.str();
}

const std::vector<Figure>& all_figures() {
  static const std::vector<Figure> kFigures = {
      {"mooring_offsets", "Where midship lies in the stages, north up", {"stages"}},
      {"mooring_stages", "Tension at the fairleads, stage by stage", {"stages"}},
      {"mooring_stages", "Tension at the fairleads and length of the lines over the advance", {"tensions", "lengths"}},
      {"move_pipe", "The pipe over the advance of the vessel", {"pipe"}, true},
  };
  return kFigures;
}

std::string figures(const MooringResults& results, int& number) {
  const bool pulled = results.operation == "pull_ahead";
  const auto makes_sense = [&](const Figure& figure, const std::string& part) {
    if (std::string(figure.id) == "move_pipe") return has_pipe(results);
    if (std::string(figure.id) == "mooring_stages" && !has_lines(results)) return false;
    return (part == "stages") != pulled && !results.stages.empty();
  };
  return figure_list(all_figures(), makes_sense, number);
}

const char* heading(const std::string& operation) {
  return operation == "pull_ahead"    ? "Pull-ahead"
         : operation == "anchor_move" ? "Move of an anchor"
         : operation == "anchor_plan" ? "Anchors of the route"
                                      : "Stages of the operation";
}

}  // namespace

std::string operation_section(const MooringResults& results, int& figure) {
  if (results.stages.empty() && results.anchors.empty()) return "";
  const std::string drawn = figures(results, figure);
  return html::section("operation", heading(results.operation),
                       anchor_table(results) + winch_table(results) + drawn +
                           (results.stages.empty() ? "" : stage_table(results)) + pipe_table(results) +
                           step_tables(results));
}

}  // namespace overbend
