#include "report/static/friction_section.h"

#include <cmath>

#include "report/page/html.h"
#include "report/page/quantity.h"

namespace overbend {
namespace {

std::string to_side(double value, std::string_view si, int digits) {
  return shown_number(std::abs(value), si, digits) + (value < 0.0 ? " to starboard" : " to port");
}

std::string route_table(const RouteResults& route) {
  html::Table table("", {{"Pipe on its route", "", true}, {"", "", true}});
  table.row({name_with_unit("Touchdown beside the route", "m"), to_side(route.laid_offset, "m", 2)});
  table.row({name_with_unit("Side load on rollers and tensioner", "N"), to_side(route.side_load_supports, "N", 2)});
  table.row({name_with_unit("Side load on the seabed", "N"), to_side(route.side_load_bed, "N", 2)});
  if (route.least_radius > 0.0) {
    table.row({name_with_unit("Least radius that friction holds, H / (mu w)", "m"),
               shown_number(route.least_radius, "m", 0)});
  }
  if (route.radius > 0.0) {
    table.row({name_with_unit("Smallest radius of the route behind touchdown", "m"),
               shown_number(route.radius, "m", 0) + (route.holds ? ", holds" : ", does not hold")});
    table.row({name_with_unit("Length of pipe that has slid sideways", "m"), shown_number(route.slid_length, "m", 1)});
    table.row({name_with_unit("Largest offset from the route", "m"), to_side(route.largest_offset, "m", 2)});
    table.row({name_with_unit("Where, astern of the stern shoe", "m"), shown_number(route.offset_x, "m", 1)});
  }
  return table.str();
}

std::vector<std::string> cells_of(const RollerFrictionCase& answer) {
  return {answer.name,
          forces().text(answer.top_tension, 1),
          forces().text(answer.bottom_tension, 1),
          shown_number(answer.lay_back, "m", 2),
          shown_number(answer.tip_side, "m", 3),
          clearances().text(answer.off_roller),
          stresses().text(answer.overbend_stress, 1),
          stresses().text(answer.sagbend_stress, 1),
          forces().text(answer.largest_reaction, 1)};
}

std::string limits_table(const std::vector<RollerFrictionCase>& answers) {
  html::Table table("",
                    {{"Limit", "", true},
                     {"Top tension", shown_name("N")},
                     {"Bottom tension", shown_name("N")},
                     {"Lay-back", shown_name("m")},
                     {"Side at the tip", shown_name("m")},
                     {"Off its roller", clearances().unit},
                     {"Overbend", shown_name("Pa")},
                     {"Sagbend", shown_name("Pa")},
                     {"Largest reaction", shown_name("N")}},
                    "dense");
  for (const RollerFrictionCase& answer : answers) table.row(cells_of(answer));
  return table.str() +
         "<p class=\"small\">frictionless: rollers turn freely. lay, haul: full friction along the pipe, as it is paid "
         "out and as it is hauled in. port, starboard: full friction across, pushing the pipe to that side. pulled "
         "across: the pipe lay straight on its route before the side load came. Side at the tip: to port of the "
         "barge's axis. Stresses are von Mises.</p>\n";
}

}  // namespace

std::string friction_section(const StaticResults& results) {
  if (!results.route && results.roller_friction.empty()) return "";
  std::string body;
  if (results.route) body += route_table(*results.route);
  if (!results.roller_friction.empty()) body += limits_table(results.roller_friction);
  return html::section("friction", "What friction decides", body);
}

}  // namespace overbend
