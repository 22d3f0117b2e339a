#include "report/static/stinger_section.h"

#include <cmath>

#include "base/constants.h"
#include "report/page/html.h"
#include "report/page/quantity.h"

namespace overbend {
namespace {

std::string name_of(const StingerSectionResult& section) {
  return section.name.empty() ? "stinger" : section.name;
}

std::string held_by(const StingerSectionResult& section) {
  if (!section.floats) return "the vessel";
  return section.at_stop ? "a stop" : "-";
}

/// Between which angles hinge friction may leave it.
std::string friction_words(const StingerSectionResult& section) {
  if (!section.floats || section.friction_moment == 0.0) return "-";
  return angles().text(section.angle_up, 2) + " to " + angles().text(section.angle_down, 2);
}

std::vector<std::string> cells_of(const StingerSectionResult& s) {
  const double per_degree = s.stiffness * kDegree;
  return {name_of(s),
          angles().text(s.angle, 2),
          friction_words(s),
          moments().text(s.roller_moment, 0),
          forces().text(s.hinge_longitudinal, 1),
          forces().text(s.hinge_vertical, 1),
          forces().text(s.hinge_force, 1),
          held_by(s),
          moments().text(s.stop_moment, 0),
          s.floats ? moments().text(per_degree, 1) : "-",
          s.natural_period > 0.0 ? html::fixed(s.natural_period, 1) : "-"};
}

std::string section_table(const StaticResults& results) {
  html::Table table("",
                    {{"Section", "", true},
                     {"Angle", shown_name("rad")},
                     {"with friction", shown_name("rad")},
                     {"Moment of the pipe", shown_name("N m")},
                     {"longitudinal", shown_name("N")},
                     {"vertical", shown_name("N")},
                     {"magnitude", shown_name("N")},
                     {"by", "", true},
                     {"moment", shown_name("N m")},
                     {"Stiffness", shown_name("N m") + "/deg"},
                     {"Period", "s"}},
                    "dense summary");
  table.groups({{"", 1}, {"Angle", 2}, {"", 1}, {"Hinge force", 3}, {"Held", 2}, {"Small turns", 2}});
  for (const StingerSectionResult& section : results.stinger) table.row(cells_of(section));
  return table.str();
}

std::string tank_table(const StaticResults& results) {
  html::Table table("",
                    {{"Tank", "", true},
                     {"Section", "", true},
                     {"Weight", shown_name("N")},
                     {"Buoyancy", shown_name("N")},
                     {"Submerged", "%"},
                     {"astern", shown_name("m")},
                     {"z", shown_name("m")},
                     {"Draught", shown_name("m")}},
                    "dense summary");
  table.groups({{"", 5}, {"Centre of buoyancy", 2}, {"", 1}});
  bool any = false;
  for (const StingerSectionResult& section : results.stinger) {
    for (const StingerTankResult& tank : section.tanks) {
      any = true;
      table.row({tank.name, name_of(section), forces().text(tank.weight, 1), forces().text(tank.buoyancy, 1),
                 html::fixed(100.0 * tank.submerged, 1), shown_number(tank.at_x, "m", 2),
                 shown_number(tank.at_z, "m", 2), shown_number(tank.draught, "m", 2)});
    }
  }
  return any ? table.str() : "";
}

}  // namespace

std::string stinger_section(const StaticResults& results) {
  if (results.stinger.empty()) return "";
  return html::section(
      "stinger", "Stinger on its hinge",
      section_table(results) + tank_table(results) +
          "<p class=\"small\">Angles are positive when the tip goes down from where it is drawn. The hinge force acts "
          "on "
          "the section, longitudinal astern and vertical upwards; moments on it are positive when they turn the tip "
          "down. Stiffness is the fall of the moment about the hinge with the angle, pipe included, the other sections "
          "held; the period follows with the inertia of body, tanks, ballast and the water that goes along. Places of "
          "tanks count from the stern shoe.</p>\n");
}

}  // namespace overbend
