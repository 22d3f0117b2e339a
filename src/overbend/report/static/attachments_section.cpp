#include "report/page/sections.h"

namespace overbend {
namespace {

/// Table with the columns of a position on the pipe; those of the attachment follow.
Table place_table(const std::string& name) {
  return {"",
          {TableColumn(name),
           {"From tensioner", "m", 2},
           {"astern", "m", 2},
           {"z", "m", 2},
           {"inclination", "rad", 2},
           {"Moment", "N m", 1},
           {"above", "N", 1},
           {"below", "N", 1},
           {"above", "N", 1},
           {"below", "N", 1}},
          "dense summary"};
}

std::vector<TableCell> place_cells(const std::string& name, const AttachedPlace& place) {
  return {name,         place.from_top,       place.astern,        place.p_W.z(),      place.inclination,
          place.moment, place.tension_before, place.tension_after, place.shear_before, place.shear_after};
}

Table point_table(const StaticResults& results) {
  Table table = place_table("Clump or buoy");
  table.column({"Pulls up", "N", 1});
  table.groups({{"", 2}, {"Place", 3}, {"", 1}, {"Tension", 2}, {"Shear", 2}, {"", 1}});
  for (const PipePointResult& point : results.points) {
    std::vector<TableCell> cells = place_cells(point.name, point.location);
    cells.emplace_back(point.force.z());
    table.row(cells);
  }
  return table;
}

Table wire_table(const StaticResults& results) {
  Table table = place_table("Wire");
  table.column({"Length", "m", 2})
      .column({"Tension", "N", 1})
      .column({"Leans by", "rad", 1})
      .column({"Of breaking load", "", 3});
  table.groups({{"", 2}, {"Place", 3}, {"", 1}, {"Tension", 2}, {"Shear", 2}, {"Wire", 4}});
  for (const PipeWireResult& wire : results.wires) {
    std::vector<TableCell> cells = place_cells(wire.name, wire.location);
    cells.insert(cells.end(), {wire.length, wire.tension_upper, wire.from_vertical_upper,
                               wire.utilisation ? TableCell(*wire.utilisation) : TableCell("-")});
    table.row(cells);
  }
  return table;
}

}  // namespace

Blocks attachments_section(const StaticResults& results) {
  const Blocks tables = point_table(results) + wire_table(results);
  if (tables.empty()) return {};
  return block::section("attachments", "Clumps, buoys and wires on the pipe",
                        tables + block::remark("Moment of the pipe there, sagging positive; its tension and shear "
                                               "above, towards the tensioner, and below: they jump by the force of "
                                               "the clump, buoy or wire."));
}

}  // namespace overbend
