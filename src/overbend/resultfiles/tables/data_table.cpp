#include "resultfiles/tables/data_table.h"

#include "resultfiles/tables/csv_table.h"

namespace overbend {

std::string csv_text(const Table& table) {
  std::vector<std::string> names;
  for (const TableColumn& column : table.columns) names.push_back(title_with_unit(column));
  CsvTable csv(names);
  for (const TableRow& row : table.rows) {
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      if (const auto* number = std::get_if<double>(&row.cells[i])) {
        csv.cell(*number * table.columns[i].factor);
      } else {
        csv.cell(cell_text(table.columns[i], row.cells[i]));
      }
    }
    csv.end_row();
  }
  return csv.text();
}

}  // namespace overbend
