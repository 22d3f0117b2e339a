#include "report/moored/hull_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/page/html.h"
#include "report/page/quantity.h"

namespace overbend {
namespace {

using html::fixed;

std::string percent(double share, int digits = 2) {
  return fixed(100.0 * share, digits);
}

std::string general(double value) {
  return value == 0.0 ? "0" : fmt::format("{:.4g}", value);
}

bool turns(const std::string& mode) {
  return mode == "roll" || mode == "pitch" || mode == "yaw";
}

std::string critical_units() {
  const std::string force = shown_name("N"), length = shown_name("m");
  return fmt::format("{0} s/{1}, {0} {1} s", force, length);
}

double critical_factor(const std::string& mode) {
  return shown_unit("N").factor * std::pow(shown_unit("m").factor, turns(mode) ? 1 : -1);
}

std::string added_mass_units() {
  const std::string mass = shown_name("kg"), length = shown_name("m");
  return fmt::format("{0}, {0} {1}, {0} {1}2", mass, length);
}

/// The part of dynamic positioning has a column only where there is one.
std::string damping_table(const std::vector<ModeDampingResult>& modes) {
  if (modes.empty()) return "";
  const bool positioned = std::any_of(modes.begin(), modes.end(),
                                      [](const ModeDampingResult& mode) { return mode.station_keeping != 0.0; });
  std::vector<html::Head> head = {{"Mode", "", true}, {"Natural period", "s"}, {"Critical", critical_units()},
                                  {"Radiation", "%"}, {"of the file", "%"},    {"Wave drift", "%"},
                                  {"Current", "%"},   {"Viscous", "%"}};
  if (positioned) head.push_back({"Positioning", "%"});
  head.push_back({"Sum", "%"});
  html::Table table("Damping of the slow motions, shares of critical damping", head, "full summary");
  for (const ModeDampingResult& mode : modes) {
    std::vector<std::string> cells = {mode.mode,
                                      fixed(mode.period, 2),
                                      general(mode.critical * critical_factor(mode.mode)),
                                      percent(mode.radiation),
                                      percent(mode.radiation_file),
                                      percent(mode.drift),
                                      percent(mode.current),
                                      percent(mode.viscous)};
    if (positioned) cells.push_back(percent(mode.station_keeping));
    cells.push_back(percent(mode.total));
    table.row(cells, mode.total < 0.0 ? "over" : "");
  }
  return table.str() +
         "<p class=\"small\">Each mode alone on the stiffness of the moorings. Radiation: of the fitted memory, beside "
         "it that of the hydrodynamic file at the same period. The drag of the mooring lines and the friction of the "
         "seabed damp besides and are not included.</p>\n";
}

bool acts(const SteadyLoad& load) {
  return load.surge != 0.0 || load.sway != 0.0 || load.yaw != 0.0;
}

std::string load_table(const HullResults& hull) {
  html::Table table(
      "Steady loads on the hull, along its axes",
      {{"", "", true}, {"Forward", shown_name("N")}, {"To port", shown_name("N")}, {"Bow to port", shown_name("N m")}},
      "plain");
  const auto row = [&](const char* name, const SteadyLoad& load) {
    if (!acts(load)) return;
    table.row({name, forces().text(load.surge, 1), forces().text(load.sway, 1), moments().text(load.yaw, 0)});
  };
  row("Mean drift of the waves", hull.drift);
  row("Current", hull.current);
  row("Wind", hull.wind);
  return acts(hull.drift) || acts(hull.current) || acts(hull.wind) ? table.str() : "";
}

std::string sensitivity_table(const HullResults& hull) {
  if (hull.current_least == 0.0 && hull.current_most == 0.0) return "";
  html::Table table("Current across the hull: what its drag coefficient decides",
                    {{"Transverse drag coefficient", "", true}, {"Force to port", shown_name("N")}}, "plain");
  table.row({"0.44, a barge in deep water by UFC 4-159-03", forces().text(hull.current_least, 1)})
      .row({"as in the model", forces().text(hull.current.sway, 1)}, "total")
      .row({"1.2, sharp edges in two dimensions", forces().text(hull.current_most, 1)});
  return table.str();
}

std::string group_table(const HullResults& hull) {
  html::Table table("Memory of radiated waves, group by group",
                    {{"Modes", "", true},
                     {"Method", "", true},
                     {"Order", ""},
                     {"Least eigenvalue of B", ""},
                     {"at", "rad/s"},
                     {"Damping added", "of largest B"}},
                    "plain");
  for (const RadiationGroupResult& group : hull.groups) {
    table.row({group.modes, group.method, group.order > 0 ? std::to_string(group.order) : "-",
               fmt::format("{:.1e}", group.least_damping), fixed(group.least_damping_omega, 3),
               group.added_damping > 0.0 ? fmt::format("{:.1e}", group.added_damping) : "none"});
  }
  return table.str();
}

std::string entry_table(const HullResults& hull) {
  html::Table table("Fit to the hydrodynamic file, entry by entry",
                    {{"Modes", "", true},
                     {"Error of B", "%"},
                     {"Error of A", "%"},
                     {"A\u221e of the file", added_mass_units()},
                     {"A\u221e in use", added_mass_units()},
                     {"difference", "%"},
                     {"Tail exponent", ""}},
                    "plain");
  for (const RadiationEntryResult& entry : hull.entries) {
    const bool known = entry.added_mass_file != 0.0;
    const double factor =
        shown_unit("kg").factor * std::pow(shown_unit("m").factor, int{turns(entry.first)} + int{turns(entry.second)});
    table.row(
        {entry.first == entry.second ? entry.first : entry.first + ", " + entry.second, percent(entry.damping_error),
         percent(entry.mass_error), general(factor * entry.added_mass_file), general(factor * entry.added_mass_used),
         known ? percent(entry.added_mass_used / entry.added_mass_file - 1.0, 2) : "-", fixed(entry.tail_exponent, 2)});
  }
  return table.str();
}

std::string fit_part(const HullResults& hull) {
  if (hull.entries.empty()) return "";
  std::string text = "<h3>Radiation</h3>\n" + group_table(hull) + entry_table(hull);
  text += fmt::format(
      "<p class=\"small\">Errors: the largest over the frequencies of the file, as shares of the largest value. The "
      "memory has {} numbers of state. A negative eigenvalue of the fitted damping would feed energy into the hull; "
      "what remains of it is lifted by the damping added. A\u221e in use is the one that belongs to the retardation "
      "functions.</p>\n",
      hull.states);
  if (hull.below_table > 0.0 || hull.above_table > 0.0) {
    text += fmt::format(
        "<p class=\"small\">Of the sea's variance, {} % lies below and {} % above the frequencies of the wave "
        "forces.</p>\n",
        percent(hull.below_table, 3), percent(hull.above_table, 3));
  }
  return text;
}

}  // namespace

std::string hull_section(const HullResults& hull) {
  return html::section("hull", "Hull",
                       damping_table(hull.damping) + "<div class=\"columns\">\n" + load_table(hull) +
                           sensitivity_table(hull) + "</div>\n" + fit_part(hull));
}

}  // namespace overbend
