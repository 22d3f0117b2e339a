#include "resultfiles/static/csv_tables.h"

#include "resultfiles/static/results_writer.h"
#include "resultfiles/tables/csv_fields.h"
#include "results/fields/static_tables.h"

namespace overbend {
namespace {

/// Cells of a roller: its box, its row, its values.
template <class Visit>
void visit_roller_line(double top, const SupportResult& support, std::size_t row, const RollerResult& roller,
                       Visit& visit) {
  visit_support(support, visit);
  visit(ResultField{"row", "1", "Number of the row in its box, from 1"}.csv("row"), static_cast<int>(row) + 1);
  visit_roller(roller, visit);
  visit_row(support.rows[row], visit);
  visit_from_tensioner(top, support.rows[row].s, visit);
}

}  // namespace

std::vector<std::string> pipe_head() {
  CsvHead head;
  const Station example{};
  visit_station(example, head);
  visit_from_tensioner(0.0, 0.0, head);
  return head.names;
}

void pipe_cells(CsvTable& table, const StaticResults& results, const Station& station) {
  CsvCells cells{table};
  visit_station(station, cells);
  visit_from_tensioner(results.stations.back().s, station.s, cells);
}

std::vector<std::string> supports_head() {
  CsvHead head;
  SupportResult support;
  support.rows.resize(1);
  visit_roller_line(0.0, support, 0, RollerResult{}, head);
  return head.names;
}

void roller_cells(CsvTable& table, const StaticResults& results, const SupportResult& support, std::size_t row,
                  const RollerResult& roller) {
  CsvCells cells{table};
  visit_roller_line(results.stations.back().s, support, row, roller, cells);
}

std::string pipe_table(const StaticResults& results) {
  CsvTable table(pipe_head());
  for (const Station& station : results.stations) {
    pipe_cells(table, results, station);
    table.end_row();
  }
  return table.text();
}

std::string supports_table(const StaticResults& results) {
  CsvTable table(supports_head());
  for (const SupportResult& support : results.supports) {
    for (std::size_t i = 0; i < support.rows.size(); ++i) {
      for (const RollerResult& roller : support.rows[i].rollers) {
        roller_cells(table, results, support, i, roller);
        table.end_row();
      }
    }
  }
  return table.text();
}

}  // namespace overbend
