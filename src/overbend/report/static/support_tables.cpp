#include <fmt/format.h>

#include "report/page/sections.h"
#include "results/tables/support_tables.h"

namespace overbend {

Blocks static_summary_table(const StaticResults& results) {
  Table table = station_summary(results);
  table.title.clear();  // the title of its section is used
  return Blocks(table) +
         block::remark(
             "X: horizontal, astern of the stern shoe; Y: to port of the vessel's axis; Z: above the mean "
             "water level. Horizontal reaction: across the box, positive to port. Pipe at a support: position "
             "at the middle of the box, maxima over its length. Separation: clear distance between pipe and "
             "roller, the smallest of the box's bottom rollers (vertical) and side rollers (horizontal); "
             "negative is penetration due to the contact stiffness or, if the pipe has passed the end of a "
             "side roller, its distance beyond the line of that roller.");
}

Blocks support_table(const StaticResults& results) {
  const Table table = roller_boxes(results);
  if (table.empty()) return {};
  return Blocks(table) +
         block::remark(
             "X, Z: middle of the box, where the underside of the coated pipe rests; Z above the mean water "
             "level. Longitudinal: along the box, positive astern; lateral: positive to port.");
}

Blocks rollers_section(const StaticResults& results) {
  Table table = single_rollers(results);
  const std::string summary = fmt::format("All {} rollers", table.rows.size());
  table.title.clear();
  return block::section("rollers", "Appendix: individual rollers, static state", block::folded(summary, table));
}

}  // namespace overbend
