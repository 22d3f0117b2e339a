#include <fmt/format.h>

#include <algorithm>

#include "report/moored/moorings_section.h"
#include "report/page/figure_list.h"

namespace overbend {
namespace {

std::string signed_text(double value, std::string_view si, int digits) {
  const std::string text = shown_number(value, si, digits);
  return text.front() == '-' || std::stod(text) == 0.0 ? text : "+" + text;
}

void add_line_columns(Table& table, const MooringResults& results, std::string_view si, int digits) {
  for (const MooringLineResult& line : results.rest.moorings) table.column({line.name, si, digits});
}

bool has_lines(const MooringResults& results) {
  return !results.rest.moorings.empty();
}

Table stage_table(const MooringResults& results) {
  Table table{has_lines(results) ? "Offset of the vessel and tension at the fairleads" : "Offset of the vessel",
              {TableColumn("Stage"), {"Surge", "m", 3}, {"Sway", "m", 3}, {"Yaw", "rad", 3}},
              "dense summary"};
  if (results.stages.empty()) return table;
  const bool positioned = !results.rest.thrust.empty();
  if (positioned) table.column({"Thrust ahead", "N", 1}).column({"Thrust to port", "N", 1});
  add_line_columns(table, results, "N", 1);
  const auto add = [&](const MooredState& state) {
    std::vector<TableCell> cells = {state.name, state.vessel.surge, state.vessel.sway, state.vessel.yaw};
    if (positioned) cells.insert(cells.end(), {state.thrust[0], state.thrust[1]});
    RowMark mark = RowMark::none;
    for (const MooringLineResult& line : state.moorings) {
      cells.push_back(line.parted ? "parted" : TableCell(line.fairlead_tension));
      if (line.utilisation.value_or(0.0) > 1.0) mark = RowMark::over;
    }
    table.row(cells, mark);
  };
  add(results.rest);
  for (const MooredState& stage : results.stages) add(stage);
  return table;
}

Blocks winch_table(const MooringResults& results) {
  if (results.winches.empty()) return {};
  Table table{"Winches, from the first stage to the last",
              {TableColumn("Line"),
               TableColumn::texts("Paid out", shown_name("m")),
               {"before", "m", 3},
               {"after", "m", 3},
               {"before", "N", 1},
               {"after", "N", 1},
               TableColumn::texts("change", shown_name("N"))}};
  table.groups({{"", 2}, {"First segment", 2}, {"Tension at the fairlead", 3}});
  for (const WinchMove& move : results.winches) {
    table.row({move.name, signed_text(move.after - move.before, "m", 3), move.before, move.after, move.tension_before,
               move.tension_after, signed_text(move.tension_after - move.tension_before, "N", 1)});
  }
  return Blocks(table) + block::remark("Paid out: negative if the winch hauls in. The pull-ahead is " +
                                       shown(results.distance, "m", 2) + "; lengths are unstressed.");
}

bool has_pipe(const MooringResults& results) {
  return !results.steps.empty() && std::all_of(results.steps.begin(), results.steps.end(),
                                               [](const MoveStep& step) { return step.pipe.has_value(); });
}

Blocks pipe_table(const MooringResults& results) {
  if (!has_pipe(results)) return {};
  const TableColumn stress("stress", "Pa", 1), strain("strain", shown_unit("strain", "1"), 4);
  Table table{"The pipe at the positions of the pull-ahead",
              {{"Advance", "m", 2},
               {"top", "N", 1},
               {"bottom", "N", 1},
               stress,
               strain,
               stress,
               strain,
               {"Largest reaction", "N", 1},
               TableColumn("at"),
               {"Lay-back", "m", 2},
               {"Stinger tip clearance", "m", 3}},
              "dense summary"};
  table.groups({{"", 1}, {"Tension", 2}, {"Overbend, bending", 2}, {"Sagbend, bending", 2}});
  for (const MoveStep& step : results.steps) {
    const PipeAtStep& pipe = *step.pipe;
    table.row({step.advance, pipe.top_tension, pipe.bottom_tension, pipe.overbend_bending_stress, pipe.overbend_strain,
               pipe.sagbend_bending_stress, pipe.sagbend_strain, pipe.max_reaction, pipe.max_reaction_support,
               pipe.lay_back, or_dash(pipe.stinger_tip_clearance)});
  }
  return table;
}

/// Long tables for the setting of the winches.
Blocks step_tables(const MooringResults& results) {
  if (results.steps.empty() || !has_lines(results)) return {};
  Table lengths{"Unstressed length of the first segments",
                {{"Advance", "m", 2}, {"Sway", "m", 3}, {"Yaw", "rad", 3}},
                "dense summary"};
  Table tensions{"Tension at the fairleads", {{"Advance", "m", 2}}, "dense summary"};
  add_line_columns(lengths, results, "m", 3);
  add_line_columns(tensions, results, "N", 1);
  for (const MoveStep& step : results.steps) {
    std::vector<TableCell> length = {step.advance, step.vessel.sway, step.vessel.yaw};
    std::vector<TableCell> tension = {step.advance};
    length.insert(length.end(), step.lengths.begin(), step.lengths.end());
    tension.insert(tension.end(), step.tensions.begin(), step.tensions.end());
    lengths.row(length);
    tensions.row(tension);
  }
  return block::folded(fmt::format("Lengths and tensions at {} positions", results.steps.size()), lengths + tensions);
}

Table anchor_table(const std::vector<AnchorDue>& anchors) {
  Table table{"Anchor moves due on the route",
              {{"Before joint", "", 0},
               TableColumn("Line"),
               TableColumn("Reason"),
               {"east", "m", 1},
               {"north", "m", 1},
               {"east", "m", 1},
               {"north", "m", 1},
               {"Length", "m", 2}}};
  table.groups({{"", 3}, {"From", 2}, {"To", 2}});
  for (const AnchorDue& due : anchors) {
    table.row(
        {due.joint, due.line, due.reason, due.from_W.x(), due.from_W.y(), due.to_W.x(), due.to_W.y(), due.length});
  }
  return table;
}

const std::vector<Figure>& all_figures() {
  static const std::vector<Figure> kFigures = {
      {"mooring_offsets", "Position of midship in the stages, north up", {"stages"}},
      {"mooring_stages", "Tension at the fairleads, stage by stage", {"stages"}},
      {"mooring_stages", "Tension at the fairleads and length of the lines over the advance", {"tensions", "lengths"}},
      {"move_pipe", "The pipe over the advance of the vessel", {"pipe"}, true},
  };
  return kFigures;
}

Blocks figures(const MooringResults& results) {
  const bool pulled = results.operation == "pull_ahead";
  return figure_list(all_figures(), [&](const Figure& figure, const std::string& part) {
    if (figure.id == "move_pipe") return has_pipe(results);
    if (figure.id == "mooring_stages" && !has_lines(results)) return false;
    return (part == "stages") != pulled && !results.stages.empty();
  });
}

const char* heading(const std::string& operation) {
  return operation == "pull_ahead"    ? "Pull-ahead"
         : operation == "anchor_move" ? "Move of an anchor"
         : operation == "anchor_plan" ? "Anchors of the route"
                                      : "Stages of the operation";
}

}  // namespace

Blocks operation_section(const MooringResults& results) {
  if (results.stages.empty() && results.anchors.empty()) return {};
  return block::section("operation", heading(results.operation),
                        anchor_table(results.anchors) + winch_table(results) + figures(results) + stage_table(results) +
                            pipe_table(results) + step_tables(results));
}

}  // namespace overbend
