#include "report/page/html.h"
#include "report/page/quantity.h"
#include "report/page/sections.h"

namespace overbend {
namespace {

std::vector<std::string> cells_of(const std::string& name, const AttachedPlace& at) {
  return {name,
          shown_number(at.from_top, "m", 2),
          shown_number(at.astern, "m", 2),
          shown_number(at.p_W.z(), "m", 2),
          angles().text(at.inclination, 2),
          moments().text(at.moment, 1),
          forces().text(at.tension_before, 1),
          forces().text(at.tension_after, 1),
          forces().text(at.shear_before, 1),
          forces().text(at.shear_after, 1)};
}

std::vector<html::Head> place_columns(const char* name) {
  return {{name, "", true},           {"From tensioner", shown_name("m")}, {"astern", shown_name("m")},
          {"z", shown_name("m")},     {"inclination", shown_name("rad")},  {"Moment", shown_name("N m")},
          {"above", shown_name("N")}, {"below", shown_name("N")},          {"above", shown_name("N")},
          {"below", shown_name("N")}};
}

std::string points_table(const StaticResults& results) {
  if (results.points.empty()) return "";
  std::vector<html::Head> columns = place_columns("Clump or buoy");
  columns.push_back({"Pulls up", shown_name("N")});
  html::Table table("", columns, "dense summary");
  table.groups({{"", 2}, {"Place", 3}, {"", 1}, {"Tension", 2}, {"Shear", 2}, {"", 1}});
  for (const PipePointResult& point : results.points) {
    std::vector<std::string> cells = cells_of(point.name, point.at);
    cells.push_back(forces().text(point.force.z(), 1));
    table.row(cells);
  }
  return table.str();
}

std::string wires_table(const StaticResults& results) {
  if (results.wires.empty()) return "";
  std::vector<html::Head> columns = place_columns("Wire");
  columns.insert(columns.end(), {{"Length", shown_name("m")},
                                 {"Tension", shown_name("N")},
                                 {"Leans by", shown_name("rad")},
                                 {"Of breaking load", ""}});
  html::Table table("", columns, "dense summary");
  table.groups({{"", 2}, {"Place", 3}, {"", 1}, {"Tension", 2}, {"Shear", 2}, {"Wire", 4}});
  for (const PipeWireResult& wire : results.wires) {
    std::vector<std::string> cells = cells_of(wire.name, wire.at);
    cells.push_back(shown_number(wire.length, "m", 2));
    cells.push_back(forces().text(wire.tension_upper, 1));
    cells.push_back(angles().text(wire.from_vertical_upper, 1));
    cells.push_back(wire.utilisation ? html::fixed(*wire.utilisation, 3) : "-");
    table.row(cells);
  }
  return table.str();
}

}  // namespace

std::string attachments_section(const StaticResults& results) {
  if (results.points.empty() && results.wires.empty()) return "";
  return html::section(
      "attachments", "Clumps, buoys and wires on the pipe",
      points_table(results) + wires_table(results) +
          "<p class=\"small\">Moment of the pipe there, sagging positive; its tension and shear above, "
          "towards the tensioner, and below: they jump by what the clump, buoy or wire pulls.</p>\n");
}

}  // namespace overbend
