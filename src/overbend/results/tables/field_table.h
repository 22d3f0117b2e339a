/// Tables whose columns are fields of results: what results/fields says of a quantity is its column everywhere.
#pragma once

#include <string>
#include <type_traits>
#include <utility>

#include "results/fields/result_field.h"
#include "results/tables/table.h"

namespace overbend {

/// Which fields have a column.
enum class TableFields {
  files,   ///< Those with a heading: in CSV and XLSX.
  people,  ///< Those that say with how many decimals they are shown: in terminal, report and page.
};

inline bool is_column(const ResultField& field, TableFields which) {
  return which == TableFields::files ? !field.heading.empty() : field.decimals.has_value();
}

/// The column of a field; `number`: its cells are numbers.
inline TableColumn field_column(const ResultField& field, TableFields which, bool number) {
  TableColumn column(std::string(which == TableFields::files ? field.heading : field.shown_title()));
  if (number) {
    const ShownUnit unit = shown_unit(field);
    column = {column.title, unit, which == TableFields::people ? *field.decimals : unit.digits - unit.more};
  }
  column.key = field.name;
  column.description = field.description;
  return column;
}

template <class Value>
inline constexpr bool kIsNumber = std::is_same_v<Value, double> || std::is_same_v<Value, std::optional<double>>;

/// Columns of the fields visited. Rows serve as examples: their values do not matter.
struct FieldColumns {
  std::vector<TableColumn>& columns;
  TableFields which = TableFields::files;

  template <class Value>
  void operator()(const ResultField& field, const Value&) {
    if (is_column(field, which)) columns.push_back(field_column(field, which, kIsNumber<Value>));
  }
};

/// The cells of one row of those columns.
struct FieldCells {
  std::vector<TableCell>& cells;
  TableFields which = TableFields::files;

  template <class Value>
  void operator()(const ResultField& field, const Value& value) {
    if (!is_column(field, which)) return;
    if constexpr (HasResultWords<Value>) {
      cells.emplace_back(word(value));
    } else if constexpr (std::is_constructible_v<TableCell, Value>) {
      cells.emplace_back(value);
    }
  }
};

/// A table with a row for each of `rows`; `visit_row(row, visitor)` hands the fields of a row to the visitor.
template <class Rows, class VisitRow>
Table field_table(std::string title, const Rows& rows, TableFields which, const VisitRow& visit_row) {
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
