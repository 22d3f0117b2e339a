#include "resultfiles/tables/data_table.h"

#include "resultfiles/tables/csv_table.h"

namespace overbend {
namespace {

struct CellWriter {
  CsvTable& table;
  void operator()(std::monostate) { table.cell(std::string()); }
  void operator()(double value) { table.cell(value); }
  void operator()(const std::string& text) { table.cell(text); }
  void operator()(const VerdictCell& verdict) { table.cell(verdict.text); }
};

}  // namespace

std::string csv_text(const DataTable& table) {
  std::vector<std::string> names;
  for (const TableColumn& column : table.columns) names.push_back(column.heading);
  CsvTable csv(names);
  for (const std::vector<TableCell>& row : table.rows) {
    for (const TableCell& cell : row) std::visit(CellWriter{csv}, cell);
    csv.end_row();
  }
  return csv.text();
}

}  // namespace overbend
