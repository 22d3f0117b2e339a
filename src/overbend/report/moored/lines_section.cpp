#include "report/moored/lines_section.h"

#include <fmt/format.h>

#include "report/page/figure_list.h"
#include "results/tables/line_tables.h"

namespace overbend {
namespace {

std::string range_text(double minimum, double maximum) {
  return shown_number(minimum, "N", 2) + " to " + shown_number(maximum, "N", 2);
}

Blocks tiles(const std::vector<LineResult>& lines, const DynamicResults* dynamics) {
  std::vector<Tile> all;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string rest = range_text(lines[i].min_tension, lines[i].max_tension);
    const LineDynamics* const moved = dynamics != nullptr ? &dynamics->lines[i] : nullptr;
    all.push_back({"Tension along " + lines[i].name,
                   moved != nullptr ? range_text(moved->min_tension, moved->max_tension) : rest, shown_name("N"),
                   moved != nullptr ? "over time; static " + rest : "static"});
  }
  return block::tiles(all);
}

Blocks end_table(const std::vector<LineResult>& lines, const DynamicResults* dynamics) {
  const Table table = line_ends(lines, dynamics != nullptr ? dynamics->lines : std::vector<LineDynamics>());
  return Blocks(table) +
         block::remark(
             "Static tension, components of the force on the end from its attachment, and declination of the line "
             "below horizontal, positive if the line is suspended from the end.");
}

/// Figures with a panel for every line.
Blocks figures(std::size_t count, bool moved) {
  std::vector<std::string> panels;
  for (std::size_t i = 0; i < count; ++i) panels.push_back(std::to_string(i));
  std::vector<Figure> all = {
      {"line_shape", "Static shape, in the vertical plane of the ends", panels},
      {"line_tension",
       moved ? "Tension along the line: static value, and range over time (band)" : "Static tension along the line",
       panels}};
  if (moved) {
    all.push_back({"history",
                   "Time history of the tension at the ends; the build-up is shaded. Values refer to all steps, "
                   "curves to the output steps",
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
