#include "report/moored/lines_section.h"

#include <fmt/format.h>

#include "report/page/figure_list.h"
#include "results/tables/line_tables.h"

namespace overbend {
namespace {

std::string range_text(double least, double largest) {
  return shown_number(least, "N", 2) + " to " + shown_number(largest, "N", 2);
}

Blocks tiles(const std::vector<LineResult>& lines, const DynamicResults* dynamics) {
  std::vector<Tile> all;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string rest = range_text(lines[i].least_tension, lines[i].largest_tension);
    const LineDynamics* const moved = dynamics != nullptr ? &dynamics->lines[i] : nullptr;
    all.push_back({"Tension along " + lines[i].name,
                   moved != nullptr ? range_text(moved->least_tension, moved->largest_tension) : rest, shown_name("N"),
                   moved != nullptr ? "over time; at rest " + rest : "at rest"});
  }
  return block::tiles(all);
}

Blocks end_table(const std::vector<LineResult>& lines, const DynamicResults* dynamics) {
  const Table table = line_ends(lines, dynamics != nullptr ? dynamics->lines : std::vector<LineDynamics>());
  return Blocks(table) +
         block::remark(
             "At rest: tension, components of the force by what holds the end, and declination of the line below "
             "horizontal, positive where it hangs from its end.");
}

/// With a panel for every line.
Blocks figures(std::size_t count, bool moved) {
  std::vector<std::string> panels;
  for (std::size_t i = 0; i < count; ++i) panels.push_back(std::to_string(i));
  std::vector<Figure> all = {
      {"line_shape", "Shape at rest, in the vertical plane of the ends", panels},
      {"line_tension",
       moved ? "Tension along the line: at rest, and its range over time (band)" : "Tension along the line at rest",
       panels}};
  if (moved) {
    all.push_back({"history",
                   "Tension at the ends in time; the build-up is shaded. Values refer to all steps, curves to the "
                   "output steps",
                   {"ends"}});
  }
  return figure_list(all);
}

}  // namespace

Blocks lines_section(const StaticResults& statics, const DynamicResults* dynamics) {
  const std::vector<LineResult>& lines = statics.lines;
  if (lines.empty()) return {};
  return block::section("lines", "Lines",
                        tiles(lines, dynamics) + figures(lines.size(), dynamics != nullptr) + lines_at_rest(lines) +
                            end_table(lines, dynamics));
}

}  // namespace overbend
