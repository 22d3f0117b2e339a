#include "report/static/friction_section.h"

#include <cmath>

#include "report/page/quantity.h"

namespace overbend {
namespace {

/// Text in both columns: each row has its own unit, in its name.
Table route_table(const RouteResults& route) {
  Table table{"", {TableColumn("Pipe on its route"), TableColumn("")}, ""};
  const auto row = [&](const std::string& name, double value, std::string_view si, int digits,
                       const std::string& note = "") {
    table.row({name_with_unit(name, si), shown_number(value, si, digits) + note});
  };
  const auto side_row = [&](const std::string& name, double value, std::string_view si) {
    row(name, std::abs(value), si, 2, value < 0.0 ? " to starboard" : " to port");
  };
  side_row("Touchdown offset from the route", route.laid_offset, "m");
  side_row("Side load on rollers and tensioner", route.side_load_supports, "N");
  side_row("Side load on the seabed", route.side_load_bed, "N");
  if (route.min_stable_radius > 0.0) row("Minimum stable radius, H / (mu w)", route.min_stable_radius, "m", 0);
  if (route.radius > 0.0) {
    row("Minimum radius of the route behind touchdown", route.radius, "m", 0,
        route.holds ? ", stable" : ", not stable");
    row("Length of pipe that has slid sideways", route.slid_length, "m", 1);
    side_row("Largest offset from the route", route.max_offset, "m");
    row("Position of that offset, astern of the stern shoe", route.offset_x, "m", 1);
  }
  return table;
}

Blocks limits(const std::vector<RollerFrictionCase>& cases) {
  if (cases.empty()) return {};
  Table table{"",
              {TableColumn("Limit"),
               {"Top tension", "N", 1},
               {"Bottom tension", "N", 1},
               {"Lay-back", "m", 2},
               {"Side at the tip", "m", 3},
               {"Off its roller", section_length(), section_length().digits},
               {"Overbend", "Pa", 1},
               {"Sagbend", "Pa", 1},
               {"Largest reaction", "N", 1}},
              "dense"};
  for (const RollerFrictionCase& limit : cases) {
    table.row({limit.name, limit.top_tension, limit.bottom_tension, limit.lay_back, limit.tip_side, limit.off_roller,
               limit.overbend_stress, limit.sagbend_stress, limit.max_reaction});
  }
  return table + block::remark(
                     "frictionless: rollers turn freely. lay, haul: full friction along the pipe, as it is paid "
                     "out and as it is hauled in. port, starboard: full friction across, pushing the pipe to that "
                     "side. pulled across: the pipe lay straight on its route before the side load was applied. "
                     "Side at the tip: to port of the vessel's axis. Stresses are von Mises.");
}

}  // namespace

Blocks friction_section(const StaticResults& results) {
  Blocks body;
  if (results.route) body += route_table(*results.route);
  return block::section("friction", "Effect of roller friction", body + limits(results.roller_friction));
}

}  // namespace overbend
