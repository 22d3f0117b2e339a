#include "seafiles/wamit_table.h"

#include "base/text.h"
#include "seafiles/text_table.h"

namespace overbend::wamit {
namespace {

std::string expected_columns(std::size_t min_columns, std::size_t max_columns) {
  const std::string max_text = std::to_string(max_columns) + " numbers";
  return min_columns == max_columns ? max_text : std::to_string(min_columns) + " to " + max_text;
}

std::optional<Row> parse_row(const TextRow& text, std::size_t min_columns, std::size_t max_columns,
                             const std::string& file, Diagnostics& diagnostics) {
  const auto reject = [&](std::string found, std::string expected) {
    diagnostics.add({Severity::error, file, text.line, 0, "", std::move(found), std::move(expected), ""});
    return std::nullopt;
  };
  if (text.cells.size() < min_columns || text.cells.size() > max_columns) {
    return reject(std::to_string(text.cells.size()) + " columns", expected_columns(min_columns, max_columns));
  }
  Row row;
  row.line = text.line;
  row.columns = text.cells.size();
  for (std::size_t k = 0; k < row.columns; ++k) {
    const std::optional<double> value = cell_number(text.cells[k]);
    if (!value) {
      return reject("'" + for_display(text.cells[k]) + "'", "a number");
    }
    row.values[k] = *value;
  }
  return row;
}

}  // namespace

std::optional<Table> read_table(const std::string& file, std::size_t min_columns, std::size_t max_columns,
                                Diagnostics& diagnostics) {
  const std::optional<std::string> text = read_text_file(file, diagnostics);
  if (!text) {
    return std::nullopt;
  }
  Table table;
  table.file = file;
  for (const TextRow& line : split_table(*text, ' ').rows) {
    if (table.rows.empty() && !cell_number(line.cells[0])) {
      continue;  // heading
    }
    const std::optional<Row> row = parse_row(line, min_columns, max_columns, file, diagnostics);
    if (!row) {
      return std::nullopt;
    }
    table.rows.push_back(*row);
  }
  if (table.rows.empty()) {
    diagnostics.add(
        {Severity::error, file, 0, 0, "", "no numbers", "rows of " + expected_columns(min_columns, max_columns), ""});
    return std::nullopt;
  }
  return table;
}

std::vector<double> first_column(const Table& table) {
  std::vector<double> values;
  for (const Row& row : table.rows) values.push_back(row.values[0]);
  return values;
}

int mode_index(double number, const std::optional<int>& body) {
  constexpr double kMaxMode = 600.0;
  const int mode = number >= 1.0 && number <= kMaxMode ? static_cast<int>(number) : 0;
  if (mode == 0 || static_cast<double>(mode) != number) return -1;
  const int local = mode - 6 * (body.value_or(1) - 1);
  if (local >= 1 && local <= 6) return local - 1;
  return body ? kOtherBody : -1;
}

}  // namespace overbend::wamit
