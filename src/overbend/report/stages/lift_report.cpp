#include "report/stages/lift_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/ranges.h"
#include "report/page/curve_chart.h"
#include "report/page/quantity.h"
#include "report/stages/lift_shapes.h"
#include "report/stages/stage_columns.h"
#include "report/stages/stage_labels.h"

namespace overbend {
namespace {

/// Calls `each(title, lift)` for the stages with an equilibrium.
void for_stages(const OperationResults& results,
                const std::function<void(const std::string&, const LiftResults&)>& each) {
  for (std::size_t i = 0; i < results.stages.size(); ++i) {
    if (results.stages[i].lay) each(stage_title(results, i), *results.stages[i].lay->lift);
  }
}

std::string values_text(const std::vector<LineValue>& values, const char* unit) {
  std::string text;
  for (const LineValue& value : values) {
    text += (text.empty() ? "" : ", ") + value.line + " " + shown(value.value, unit, 2);
  }
  return text;
}

std::string vessel_offset_text(const LayStageDescription& stage) {
  if (!stage.vessel) return "";
  return fmt::format("{} ahead, {} to port, {} clockwise", shown(stage.vessel->x, "m", 2),
                     shown(stage.vessel->y, "m", 2), shown(stage.vessel->heading, "rad", 2));
}

/// Actions of each stage, and the reason if it is infeasible.
Table procedure_table(const OperationResults& results, const std::optional<Description>& description) {
  Table table{"What is done",
              {TableColumn("Stage"), TableColumn("Lengths"), TableColumn("Tensions"), TableColumn("Vessel"),
               TableColumn("Weld"), TableColumn("State")},
              "dense"};
  for (std::size_t i = 0; i < results.stages.size(); ++i) {
    const StageResult& stage = results.stages[i];
    const bool is_described = description && i < description->operation.lay.stages.size();
    const LayStageDescription& asked = is_described ? description->operation.lay.stages[i] : stage.stage;
    table.row({stage_title(results, i), values_text(asked.lengths, "m"), values_text(asked.tensions, "N"),
               vessel_offset_text(asked), asked.join ? asked.join->first + " to " + asked.join->second : "",
               stage.failure ? stage.failure->what + ": " + stage.failure->why : "equilibrium found"},
              stage.failure ? RowMark::over : RowMark::none);
  }
  return table;
}

TableCell end_cell(const LiftedEnd& end) {
  return end.free ? TableCell(end.location.place.z()) : "held";
}

Table line_table(const OperationResults& results) {
  Table table{"Lines at every stage",
              {TableColumn("Stage"),
               TableColumn("Line"),
               {"first, z", "m", 2},
               {"inclination", "rad", 2},
               {"second, z", "m", 2},
               {"sagging", "N m", 1},
               {"hogging", "N m", 1},
               {"largest at", "m", 1},
               {"bending", "Pa", 1},
               {"least", "N", 1},
               {"largest", "N", 1},
               {"Lift-off", "m", 2},
               {"Suspended", "m", 2}},
              "dense summary"};
  table.groups({{"", 2}, {"Ends", 3}, {"Bending moment", 3}, {"Stress", 1}, {"Tension", 2}, {"", 2}});
  for_stages(results, [&](const std::string& title, const LiftResults& lift) {
    for (const LiftedLine& line : lift.lines) {
      table.row({title, line.name, end_cell(line.first), line.first.location.inclination, end_cell(line.second),
                 line.sagging.value, line.hogging.value, line.bending.location.arc_length, line.bending_stress,
                 line.min_tension, line.max_tension, line.lift_off ? line.lift_off->arc_length : TableCell(),
                 line.suspended_length});
    }
  });
  return table;
}

Table davit_table(const OperationResults& results) {
  Table table{"Attached lines at every stage",
              {TableColumn("Stage"),
               TableColumn("Line"),
               {"Length", "m", 2},
               {"upper", "N", 1},
               {"lower", "N", 1},
               {"Use", kPercent, 1},
               {"From vertical", "rad", 1},
               TableColumn("on"),
               {"z", "m", 2},
               {"moment", "N m", 1},
               {"tension before", "N", 1},
               {"tension after", "N", 1}},
              "dense summary"};
  table.groups({{"", 3}, {"Tension", 2}, {"", 2}, {"At its attachment", 5}});
  for_stages(results, [&](const std::string& title, const LiftResults& lift) {
    for (const LiftedWire& wire : lift.davits) {
      table.row({title, wire.name, wire.length, wire.tension_upper, wire.tension_lower, or_dash(wire.utilisation),
                 wire.from_vertical_upper, wire.on, wire.location.place.z(), wire.moment, wire.tension_before,
                 wire.tension_after});
    }
  });
  return table;
}

Table weld_table(const OperationResults& results) {
  Table table{"Ends to be welded, and the weld",
              {TableColumn("Stage"),
               {"dx", "m", 3},
               {"dy", "m", 3},
               {"dz", "m", 3},
               {"angle", "rad", 2},
               {"tension", "N", 2},
               {"shear", "N", 2},
               {"moment", "N m", 1},
               {"z", "m", 2}},
              "dense summary"};
  table.groups({{"", 1}, {"Gap, second end minus first", 4}, {"Weld: second line on the first", 4}});
  for_stages(results, [&](const std::string& title, const LiftResults& lift) {
    if (!lift.gap && !lift.join) return;
    std::vector<TableCell> cells = {title};
    if (lift.gap) cells = {title, lift.gap->dx, lift.gap->dy, lift.gap->dz, lift.gap->angle};
    cells.resize(5);
    if (lift.join) {
      cells.insert(cells.end(),
                   {lift.join->tension, lift.join->shear, lift.join->moment, lift.join->location.place.z()});
    }
    cells.resize(table.columns.size());
    table.row(cells);
  });
  return table;
}

/// Names of the lines that are pipe at any stage.
std::vector<std::string> line_names(const OperationResults& results) {
  std::vector<std::string> names;
  for_stages(results, [&](const std::string&, const LiftResults& lift) {
    for (const LiftedLine& line : lift.lines) {
      if (ranges::find(names, line.name) == names.end()) names.push_back(line.name);
    }
  });
  return names;
}

/// One curve for every stage, of a line by its name.
std::vector<ChartCurve> line_curves(const OperationResults& results, const std::string& name,
                                    const std::function<std::pair<double, double>(const LiftedNode&)>& point) {
  std::vector<ChartCurve> curves;
  for_stages(results, [&](const std::string& title, const LiftResults& lift) {
    for (const LiftedLine& line : lift.lines) {
      if (line.name != name) continue;
      // Pipe far behind the lift-off is omitted: it is uniform.
      const double reach = 1.15 * line.suspended_length + 10.0;
      ChartCurve& curve = curves.emplace_back();
      curve.name = title;
      for (const LiftedNode& node : line.nodes) {
        const double from_free = line.second.free && !line.first.free
                                     ? line.nodes.back().location.arc_length - node.location.arc_length
                                     : node.location.arc_length;
        if (from_free <= reach) curve.points.push_back(point(node));
      }
    }
  });
  return curves;
}

Blocks figures(const OperationResults& results, const std::optional<Description>& description) {
  Blocks blocks = lift_side_view(results, description);
  const double length = shown_unit("m").factor, moment = shown_unit("N m").factor, force = shown_unit("N").factor;
  for (const std::string& name : line_names(results)) {
    CurveChart moments, tensions;
    moments.across = tensions.across = name_with_unit("Arc length", "m");
    moments.up = name_with_unit("Bending moment, sagging positive", "N m");
    moments.curves = line_curves(results, name, [&](const LiftedNode& node) {
      return std::pair{length * node.location.arc_length, moment * node.sagging};
    });
    tensions.up = name_with_unit("Effective tension", "N");
    tensions.curves = line_curves(results, name, [&](const LiftedNode& node) {
      return std::pair{length * node.location.arc_length, force * node.tension};
    });
    blocks += curve_figure(moments, name + ": bending moment in the vertical plane") +
              curve_figure(tensions, name + ": effective tension");
  }
  return blocks;
}

}  // namespace

Blocks lift_sections(const OperationResults& results, const std::optional<Description>& description) {
  return block::section("procedure", "Procedure", procedure_table(results, description)) +
         block::section("stages", "Stages", figures(results, description) + line_table(results)) +
         block::section("davits", "Davit cables and other attached lines", davit_table(results) + weld_table(results));
}

}  // namespace overbend
