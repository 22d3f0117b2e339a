#include "results/tables/support_tables.h"

#include <fmt/format.h>

#include <algorithm>

#include "results/fields/location_names.h"
#include "results/result_enum_names.h"

namespace overbend {
namespace {

TableCell sides(const SupportResult& box) {
  return box.has_sides ? TableCell(box.separation_lateral) : TableCell();
}

/// Pipe forces and stresses of a row of the static summary.
template <class Row>
std::vector<TableCell> pipe_cells(const StaticResults& results, const Row& row) {
  return {row.effective_tension, row.bending_moment,
          row.bending_stress,    row.strain,
          row.von_mises,         yield_percent(results, row.s, row.von_mises)};
}

/// A row of the static summary: the pipe at a station; for a box, at its middle, with the maxima over its length.
void add_station(Table& table, const StaticResults& results, const Station& station, const std::string& name,
                 const std::string& part, const SupportResult* box = nullptr) {
  const Vec3 p = ship_point(results, station.p_W);
  std::vector<TableCell> cells = {name, part, from_tensioner(results, station.s), p.x(), p.y(), p.z()};
  if (box != nullptr) {
    cells.insert(cells.end(), {box->vertical, box->lateral, box->separation, sides(*box)});
  } else {
    cells.resize(cells.size() + 4);
  }
  const std::vector<TableCell> pipe = box != nullptr ? pipe_cells(results, *box) : pipe_cells(results, station);
  cells.insert(cells.end(), pipe.begin(), pipe.end());
  table.row(cells);
}

int rows_in_contact(const SupportResult& box) {
  return static_cast<int>(
      std::count_if(box.rows.begin(), box.rows.end(), [](const RowResult& row) { return row.reaction > 0.0; }));
}

double max_roller_reaction(const SupportResult& box) {
  double max_reaction = 0.0;
  for (const RowResult& row : box.rows) {
    for (const RollerResult& roller : row.rollers) {
      max_reaction = std::max(max_reaction, roller.reaction);
    }
  }
  return max_reaction;
}

}  // namespace

Table station_summary(const StaticResults& results) {
  Table table{"Static summary",
              {TableColumn("Station"),
               TableColumn("Pipe section"),
               {"Along pipe", "m", 2},
               {"X", "m", 2},
               {"Y", "m", 2},
               {"Z", "m", 2},
               {"vert.", "N", 1},
               {"horiz.", "N", 1},
               {"vert.", "m", 4},
               {"horiz.", "m", 4},
               {"Tension", "N", 1},
               {"Moment", "N m", 1},
               {"Bending stress", "Pa", 1},
               {"Strain", shown_unit("strain", "1"), 4},
               {"von Mises", "Pa", 1},
               {"Yield", "%", 1}},
              "dense summary"};
  table.groups({{"", 2}, {"Pipe axis", 4}, {"Support reaction", 2}, {"Support separation", 2}, {"Pipe", 6}});
  add_station(table, results, results.stations.back(), "tensioner", "TENSIONER");
  for (const SupportResult& box : results.supports) {
    add_station(table, results, station_at(results, box.s), box.name, box.stinger ? "STINGER" : "LAYBARGE", &box);
  }
  add_station(table, results, station_at(results, results.sagbend.von_mises.s), "sagbend max.", "SAGBEND");
  add_station(table, results, station_at(results, results.touchdown.s), "touchdown", "SEABED");
  add_station(table, results, results.stations.front(), "anchor", "SEABED");
  return table;
}

Table roller_boxes(const StaticResults& results) {
  Table table{"Roller boxes",
              {TableColumn("Box"),
               TableColumn("On"),
               {"X", "m", 3},
               {"Z", "m", 3},
               {"Incline", "rad", 2},
               {"Length", "m", 3},
               {"resultant", "N", 1},
               {"vertical", "N", 1},
               {"longit.", "N", 1},
               {"lateral", "N", 1},
               {"Largest roller", "N", 1},
               TableColumn::texts("Rows loaded"),
               {"bottom", "m", 4},
               {"sides", "m", 4}},
              "dense boxes"};
  table.groups({{"", 6}, {"Reaction on the pipe", 4}, {"", 2}, {"Smallest separation", 2}});
  for (const SupportResult& box : results.supports) {
    const Vec3 p = ship_point(results, box.p_W);
    table.row({box.name, box.stinger ? "stinger" : "ramp", p.x(), p.z(), box.inclination, box.length, box.reaction,
               box.vertical, box.longitudinal, box.lateral, max_roller_reaction(box),
               fmt::format("{} of {}", rows_in_contact(box), box.rows.size()), box.separation, sides(box)});
  }
  return table;
}

Table single_rollers(const StaticResults& results) {
  Table table{"Rollers",
              {TableColumn("Box"),
               {"Row", "", 0},
               TableColumn("Roller"),
               {"normal", "N", 2},
               {"vertical", "N", 2},
               {"longit.", "N", 2},
               {"lateral", "N", 2},
               {"Separation", "m", 4},
               {"Off end", "m", 3}},
              "dense rollers"};
  table.groups({{"", 3}, {"Reaction on the pipe", 4}, {"", 2}});
  for (const SupportResult& box : results.supports) {
    for (std::size_t row = 0; row < box.rows.size(); ++row) {
      for (const RollerResult& r : box.rows[row].rollers) {
        table.row({box.name, row + 1, word(r.position), r.reaction, r.vertical, r.longitudinal, r.lateral, r.separation,
                   r.off_end},
                  r.reaction > 0.0 ? RowMark::loaded : RowMark::none);
      }
    }
  }
  return table;
}

}  // namespace overbend
