#include "report/friction_section.h"

#include <cmath>

#include "report/html.h"
#include "report/quantity.h"

namespace overbend {
namespace {

std::string to_side(double value, int digits) {
  return html::fixed(std::abs(value), digits) + (value < 0.0 ? " to starboard" : " to port");
}

std::string route_table(const RouteResults& route) {
  html::Table table("", {{"Pipe on its route", "", true}, {"", "", true}});
  table.row({"Touchdown beside the route [m]", to_side(route.laid_offset, 2)});
  table.row({"Side load on rollers and tensioner [kN]", to_side(1e-3 * route.side_load_supports, 2)});
  table.row({"Side load on the seabed [kN]", to_side(1e-3 * route.side_load_bed, 2)});
  if (route.least_radius > 0.0) {
    table.row({"Least radius that friction holds, H / (mu w) [m]", html::fixed(route.least_radius, 0)});
  }
  if (route.radius > 0.0) {
    table.row({"Smallest radius of the route behind touchdown [m]",
               html::fixed(route.radius, 0) + (route.holds ? ", holds" : ", does not hold")});
    table.row({"Length of pipe that has slid sideways [m]", html::fixed(route.slid_length, 1)});
    table.row({"Largest offset from the route [m]", to_side(route.largest_offset, 2)});
    table.row({"Where, astern of the stern shoe [m]", html::fixed(route.offset_x, 1)});
  }
  return table.str();
}

std::vector<std::string> cells_of(const RollerFrictionCase& answer) {
  return {answer.name,
          forces().text(answer.top_tension, 1),
          forces().text(answer.bottom_tension, 1),
          html::fixed(answer.lay_back, 2),
          html::fixed(answer.tip_side, 3),
          clearances().text(answer.off_roller),
          stresses().text(answer.overbend_stress, 1),
          stresses().text(answer.sagbend_stress, 1),
          forces().text(answer.largest_reaction, 1)};
}

std::string limits_table(const std::vector<RollerFrictionCase>& answers) {
  html::Table table("",
                    {{"Limit", "", true},
                     {"Top tension", "kN"},
                     {"Bottom tension", "kN"},
                     {"Lay-back", "m"},
                     {"Side at the tip", "m"},
                     {"Off its roller", "mm"},
                     {"Overbend", "MPa"},
                     {"Sagbend", "MPa"},
                     {"Largest reaction", "kN"}},
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
