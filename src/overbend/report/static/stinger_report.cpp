#include "report/static/stinger_report.h"

#include "base/constants.h"

namespace overbend {
namespace {

std::string section_name(const StingerSectionResult& section) {
  return section.name.empty() ? "stinger" : section.name;
}

std::string held_by(const StingerSectionResult& section) {
  if (!section.floats) return "the vessel";
  return section.at_stop ? "a stop" : "-";
}

/// Range of angles due to hinge friction.
std::string friction_text(const StingerSectionResult& section) {
  if (!section.floats || section.friction_moment == 0.0) return "-";
  return shown_number(section.angle_up, "rad", 2) + " to " + shown_number(section.angle_down, "rad", 2);
}

Table section_table(const StaticResults& results) {
  Table table{"",
              {TableColumn("Section"),
               {"Angle", "rad", 2},
               TableColumn::texts("with friction", shown_name("rad")),
               {"Moment of the pipe", "N m", 0},
               {"longitudinal", "N", 1},
               {"vertical", "N", 1},
               {"magnitude", "N", 1},
               TableColumn("by"),
               {"moment", "N m", 0},
               {"Stiffness", "N m", 1},
               {"Period", "s", 1}},
              "dense summary"};
  table.columns[9].unit += "/deg";
  table.groups({{"", 1}, {"Angle", 2}, {"", 1}, {"Hinge force", 3}, {"Held", 2}, {"Small rotations", 2}});
  for (const StingerSectionResult& s : results.stinger) {
    table.row({section_name(s), s.angle, friction_text(s), s.roller_moment, s.hinge_longitudinal, s.hinge_vertical,
               s.hinge_force, held_by(s), s.stop_moment, s.floats ? TableCell(s.stiffness * kDegree) : TableCell("-"),
               s.natural_period > 0.0 ? TableCell(s.natural_period) : TableCell("-")});
  }
  return table;
}

Table tank_table(const StaticResults& results) {
  Table table{"",
              {TableColumn("Tank"),
               TableColumn("Section"),
               {"Weight", "N", 1},
               {"Buoyancy", "N", 1},
               {"Submerged", "%", 1},
               {"astern", "m", 2},
               {"z", "m", 2},
               {"Draught", "m", 2}},
              "dense summary"};
  table.groups({{"", 5}, {"Centre of buoyancy", 2}, {"", 1}});
  for (const StingerSectionResult& section : results.stinger) {
    for (const StingerTankResult& tank : section.tanks) {
      table.row({tank.name, section_name(section), tank.weight, tank.buoyancy, 100.0 * tank.submerged, tank.at_x,
                 tank.at_z, tank.draught});
    }
  }
  return table;
}

}  // namespace

Blocks stinger_section(const StaticResults& results) {
  if (results.stinger.empty()) return {};
  return block::section(
      "stinger", "Stinger on its hinge",
      section_table(results) + tank_table(results) +
          block::remark(
              "Angles are measured from the nominal position, positive for tip down. The hinge force acts on the "
              "section, longitudinal astern and vertical upwards; moments on it are positive for tip down. "
              "Stiffness is the restoring moment about the hinge per angle, including the pipe, with the other "
              "sections fixed; the period includes the inertia of body, tanks and ballast and the added mass. "
              "Positions of tanks are measured from the stern shoe."));
}

}  // namespace overbend
