/// Tables whose columns are result fields: the definition in results/fields applies to every output.
#pragma once

#include <string>
#include <type_traits>
#include <utility>

#include "results/fields/result_field.h"
#include "results/tables/table.h"

namespace overbend {

/// Selection of fields that have a column.
enum class TableAudience {
  files,   ///< Fields with a heading: in CSV and XLSX.
  people,  ///< Fields with a number of decimals: in terminal, report and page.
};

/// True if the field has a column for this audience.
inline bool is_column(const ResultField& field, TableAudience which) {
  return which == TableAudience::files ? !field.heading.empty() : field.decimals.has_value();
}

/// Returns the column of a field; `number`: its cells are numbers.
inline TableColumn field_column(const ResultField& field, TableAudience which, bool number) {
  TableColumn column(std::string(which == TableAudience::files ? field.heading : field.shown_title()));
  if (number) {
    const ShownUnit unit = shown_unit(field);
    column = {column.title, unit, which == TableAudience::people ? *field.decimals : unit.digits - unit.more};
  }
  column.key = field.name;
  column.description = field.description;
  return column;
}

template <class Value>
inline constexpr bool kIsNumber = std::is_same_v<Value, double> || std::is_same_v<Value, std::optional<double>>;

/// Collects the columns of the visited fields. Rows are examples only: their values are ignored.
struct FieldColumns {
  std::vector<TableColumn>& columns;
  TableAudience which = TableAudience::files;

  template <class Value>
  void operator()(const ResultField& field, const Value&) {
    if (is_column(field, which)) columns.push_back(field_column(field, which, kIsNumber<Value>));
  }
};

/// Collects the cells of one row of these columns.
struct FieldCells {
  std::vector<TableCell>& cells;
  TableAudience which = TableAudience::files;

  template <class Value>
  void operator()(const ResultField& field, const Value& value) {
    if (!is_column(field, which)) return;
    if constexpr (HasResultEnumNames<Value>) {
      cells.emplace_back(word(value));
    } else if constexpr (std::is_constructible_v<TableCell, Value>) {
      cells.emplace_back(value);
    }
  }
};

/// Returns a table with a row for each of `rows`; `visit_row(row, visitor)` passes the fields of a row to the visitor.
template <class Rows, class VisitRow>
Table field_table(std::string title, const Rows& rows, TableAudience which, const VisitRow& visit_row) {
  Table table{std::move(title), {}};
  FieldColumns head{table.columns, which};
  visit_row(typename Rows::value_type{}, head);
  for (const auto& row : rows) {
    std::vector<TableCell> cells;
    FieldCells visit{cells, which};
    visit_row(row, visit);
    table.row(std::move(cells));
  }
  return table;
}

}  // namespace overbend
