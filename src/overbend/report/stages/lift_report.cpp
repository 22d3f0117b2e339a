#include "report/stages/lift_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/shown_unit.h"
#include "report/page/curve_chart.h"
#include "report/page/html.h"
#include "report/stages/lift_shapes.h"
#include "report/stages/stage_words.h"

namespace overbend {
namespace {

using html::fixed;

/// Calls `each(title, lift)` for the stages that stand.
void for_stages(const OperationResults& results,
                const std::function<void(const std::string&, const LiftResults&)>& each) {
  for (std::size_t i = 0; i < results.stages.size(); ++i) {
    if (results.stages[i].lay) each(stage_title(results, i), *results.stages[i].lay->lift);
  }
}

std::string values_of(const std::vector<LineValue>& values, const char* unit) {
  std::string words;
  for (const LineValue& value : values) {
    words += (words.empty() ? "" : ", ") + value.line + " " + shown(value.value, unit, 2);
  }
  return words;
}

std::string vessel_words(const LayStageDescription& stage) {
  if (!stage.vessel) return "";
  return fmt::format("{} ahead, {} to port, {} clockwise", shown(stage.vessel->x, "m", 2),
                     shown(stage.vessel->y, "m", 2), shown(stage.vessel->heading, "rad", 2));
}

/// What is done at each stage, and why one cannot be.
std::string procedure_table(const OperationResults& results, const std::optional<Description>& description) {
  html::Table table("What is done",
                    {{"Stage", "", true},
                     {"Lengths", "", true},
                     {"Tensions", "", true},
                     {"Vessel", "", true},
                     {"Weld", "", true},
                     {"State", "", true}},
                    "dense");
  for (std::size_t i = 0; i < results.stages.size(); ++i) {
    const StageResult& stage = results.stages[i];
    const bool told = description && i < description->operation.lay.stages.size();
    const LayStageDescription& asked = told ? description->operation.lay.stages[i] : stage.stage;
    const std::string weld = asked.join ? asked.join->first + " to " + asked.join->second : "";
    const std::string state = stage.failure ? stage.failure->what + ": " + stage.failure->why : "equilibrium found";
    table.row({stage_title(results, i), values_of(asked.lengths, "m"), values_of(asked.tensions, "N"),
               vessel_words(asked), weld, state},
              stage.failure ? "over" : "");
  }
  return table.str();
}

std::string end_words(const LiftedEnd& end) {
  return end.free ? shown_number(end.at.place.z(), "m", 2) : "held";
}

std::string line_table(const OperationResults& results) {
  html::Table table("Lines at every stage",
                    {{"Stage", "", true},
                     {"Line", "", true},
                     {"first, z", shown_name("m")},
                     {"inclination", shown_name("rad")},
                     {"second, z", shown_name("m")},
                     {"sagging", shown_name("N m")},
                     {"hogging", shown_name("N m")},
                     {"largest at", shown_name("m")},
                     {"bending", shown_name("Pa")},
                     {"least", shown_name("N")},
                     {"largest", shown_name("N")},
                     {"Lift-off", shown_name("m")},
                     {"Suspended", shown_name("m")}},
                    "dense summary");
  table.groups({{"", 2}, {"Ends", 3}, {"Bending moment", 3}, {"Stress", 1}, {"Tension", 2}, {"", 2}});
  for_stages(results, [&](const std::string& title, const LiftResults& lift) {
    for (const LiftedLine& line : lift.lines) {
      table.row({title, line.name, end_words(line.first), shown_number(line.first.at.inclination, "rad", 2),
                 end_words(line.second), shown_number(line.sagging.value, "N m", 1),
                 shown_number(line.hogging.value, "N m", 1), shown_number(line.bending.at.arc_length, "m", 1),
                 shown_number(line.bending_stress, "Pa", 1), shown_number(line.least_tension, "N", 1),
                 shown_number(line.largest_tension, "N", 1),
                 line.lift_off ? shown_number(line.lift_off->arc_length, "m", 2) : "",
                 shown_number(line.suspended_length, "m", 2)});
    }
  });
  return table.str();
}

std::string davit_table(const OperationResults& results) {
  html::Table table("Lines on lines at every stage",
                    {{"Stage", "", true},
                     {"Line", "", true},
                     {"Length", shown_name("m")},
                     {"upper", shown_name("N")},
                     {"lower", shown_name("N")},
                     {"Use", "%"},
                     {"From vertical", shown_name("rad")},
                     {"on", "", true},
                     {"z", shown_name("m")},
                     {"moment", shown_name("N m")},
                     {"tension before", shown_name("N")},
                     {"tension after", shown_name("N")}},
                    "dense summary");
  table.groups({{"", 3}, {"Tension", 2}, {"", 2}, {"At its attachment", 5}});
  for_stages(results, [&](const std::string& title, const LiftResults& lift) {
    for (const LiftedWire& wire : lift.davits) {
      table.row({title, wire.name, shown_number(wire.length, "m", 2), shown_number(wire.tension_upper, "N", 1),
                 shown_number(wire.tension_lower, "N", 1), wire.utilisation ? fixed(100.0 * *wire.utilisation, 1) : "-",
                 shown_number(wire.from_vertical_upper, "rad", 1), wire.on, shown_number(wire.at.place.z(), "m", 2),
                 shown_number(wire.moment, "N m", 1), shown_number(wire.tension_before, "N", 1),
                 shown_number(wire.tension_after, "N", 1)});
    }
  });
  return table.str();
}

std::string weld_table(const OperationResults& results) {
  html::Table table("Ends to be welded, and the weld",
                    {{"Stage", "", true},
                     {"dx", shown_name("m")},
                     {"dy", shown_name("m")},
                     {"dz", shown_name("m")},
                     {"angle", shown_name("rad")},
                     {"tension", shown_name("N")},
                     {"shear", shown_name("N")},
                     {"moment", shown_name("N m")},
                     {"z", shown_name("m")}},
                    "dense summary");
  table.groups({{"", 1}, {"Gap, second end less first", 4}, {"Weld: second line on the first", 4}});
  bool any = false;
  for_stages(results, [&](const std::string& title, const LiftResults& lift) {
    std::vector<std::string> cells(9);
    cells[0] = title;
    if (lift.gap) {
      cells[1] = shown_number(lift.gap->dx, "m", 3);
      cells[2] = shown_number(lift.gap->dy, "m", 3);
      cells[3] = shown_number(lift.gap->dz, "m", 3);
      cells[4] = shown_number(lift.gap->angle, "rad", 2);
    }
    if (lift.join) {
      cells[5] = shown_number(lift.join->tension, "N", 2);
      cells[6] = shown_number(lift.join->shear, "N", 2);
      cells[7] = shown_number(lift.join->moment, "N m", 1);
      cells[8] = shown_number(lift.join->at.place.z(), "m", 2);
    }
    if (!lift.gap && !lift.join) return;
    any = true;
    table.row(cells);
  });
  return any ? table.str() : "";
}

/// Names of the lines that are pipe at any stage.
std::vector<std::string> line_names(const OperationResults& results) {
  std::vector<std::string> names;
  for_stages(results, [&](const std::string&, const LiftResults& lift) {
    for (const LiftedLine& line : lift.lines) {
      if (std::ranges::find(names, line.name) == names.end()) names.push_back(line.name);
    }
  });
  return names;
}

/// One curve for every stage, of a line by its name.
std::vector<ChartCurve> curves_of(
    const OperationResults& results, const std::string& name,
    const std::function<std::pair<double, double>(const LiftedLine&, const LiftedNode&)>& point) {
  std::vector<ChartCurve> curves;
  for_stages(results, [&](const std::string& title, const LiftResults& lift) {
    for (const LiftedLine& line : lift.lines) {
      if (line.name != name) continue;
      // What lies far behind is left out: it is all alike.
      const double reach = 1.15 * line.suspended_length + 10.0;
      ChartCurve& curve = curves.emplace_back();
      curve.name = title;
      for (const LiftedNode& node : line.nodes) {
        const double from_free = line.second.free && !line.first.free
                                     ? line.nodes.back().at.arc_length - node.at.arc_length
                                     : node.at.arc_length;
        if (from_free <= reach) curve.points.push_back(point(line, node));
      }
    }
  });
  return curves;
}

std::string figures(const OperationResults& results, const std::optional<Description>& description, int& number) {
  std::string out = lift_side_view(results, description, number);
  const double length = shown_unit("m").factor, moment = shown_unit("N m").factor, force = shown_unit("N").factor;
  const std::string metres = std::string(" [") + shown_name("m") + "]";
  int count = 0;
  for (const std::string& name : line_names(results)) {
    const std::string id = "lift-" + std::to_string(++count);
    CurveChart moments{id + "-moment",
                       "Arc length" + metres,
                       std::string("Bending moment, sagging positive [") + shown_name("N m") + "]",
                       {},
                       {},
                       {}};
    moments.curves = curves_of(results, name, [&](const LiftedLine&, const LiftedNode& node) {
      return std::pair{length * node.at.arc_length, moment * node.sagging};
    });
    out += curve_figure(moments, fmt::format("Figure {}. {}: bending moment in the vertical plane", ++number, name));
    CurveChart tensions{
        id + "-tension", "Arc length" + metres, std::string("Effective tension [") + shown_name("N") + "]", {}, {}, {}};
    tensions.curves = curves_of(results, name, [&](const LiftedLine&, const LiftedNode& node) {
      return std::pair{length * node.at.arc_length, force * node.tension};
    });
    out += curve_figure(tensions, fmt::format("Figure {}. {}: effective tension", ++number, name));
  }
  return out;
}

}  // namespace

std::string lift_sections(const OperationResults& results, const std::optional<Description>& description, int& figure) {
  return html::section("procedure", "Procedure", procedure_table(results, description)) +
         html::section("stages", "Stages", figures(results, description, figure) + line_table(results)) +
         html::section("davits", "Davits and other lines on lines", davit_table(results) + weld_table(results));
}

}  // namespace overbend
