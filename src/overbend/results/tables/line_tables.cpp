#include "results/tables/line_tables.h"

#include <fmt/format.h>

namespace overbend {

Table lines_at_rest(const std::vector<LineResult>& lines) {
  Table table{"Lines at rest",
              {TableColumn("Line"),
               {"Length", "m", 2},
               {"On bed", "m", 1},
               {"Submerged weight", "N", 2},
               {"Least", "N", 2},
               {"Largest", "N", 2},
               {"Breaking load", "%", 1},
               {"Elements", "", 0},
               TableColumn::texts("Unbalanced", "of weight")},
              "dense summary"};
  table.groups({{"", 4}, {"Tension", 2}, {"", 3}});
  for (const LineResult& line : lines) {
    table.row({line.name, line.length, line.on_bed, line.weight, line.min_tension, line.max_tension,
               or_dash(line.utilisation, 100.0), line.elements, fmt::format("{:.1e}", line.residual)});
  }
  return table;
}

Table line_ends(const std::vector<LineResult>& lines, const std::vector<LineDynamics>& in_time) {
  Table table{"Ends of the lines",
              {TableColumn("Line"),
               TableColumn("End"),
               {"Tension", "N", 2},
               {"east", "N", 2},
               {"north", "N", 2},
               {"up", "N", 2},
               {"Declination", "rad", 2}},
              "dense summary"};
  if (!in_time.empty()) {
    for (const char* statistic : {"min", "max", "mean", "std"}) table.column({statistic, "N", 2});
  }
  table.groups({{"", 3}, {"Force on the line", 3}, {"", 1}, {"Tension over time", 4}});
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto add = [&](const char* name, const LineEndResult& end, const SummaryStatistics* over_time) {
      std::vector<TableCell> cells = {lines[i].name, name,          end.tension,    end.force.x(),
                                      end.force.y(), end.force.z(), end.declination};
      if (over_time != nullptr) {
        cells.insert(cells.end(), {over_time->min, over_time->max, over_time->mean, over_time->std});
      }
      table.row(cells);
    };
    const LineDynamics* const moved = in_time.empty() ? nullptr : &in_time.at(i);
    add("first", lines[i].first, moved != nullptr ? &moved->first_tension : nullptr);
    add("second", lines[i].second, moved != nullptr ? &moved->second_tension : nullptr);
  }
  return table;
}

}  // namespace overbend
