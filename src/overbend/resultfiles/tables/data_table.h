/// A table for files: columns with their units and rows of typed cells, from which CSV and XLSX are written alike.
#pragma once

#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "resultfiles/tables/csv_fields.h"
#include "results/fields/result_field.h"
#include "results/verdict.h"

namespace overbend {

/// A verdict: shown in a colour where the file has any.
struct VerdictCell {
  VerdictKind kind = VerdictKind::not_judged;
  std::string text;
};

/// monostate: an empty cell.
using TableCell = std::variant<std::monostate, double, std::string, VerdictCell>;

struct TableColumn {
  std::string heading;  ///< With its unit: "top tension [kN]".
  int digits = 3;       ///< Decimals shown where the file has a format; the number itself is whole.
};

struct DataTable {
  std::string name;  ///< Of the sheet.
  std::vector<TableColumn> columns;
  std::vector<std::vector<TableCell>> rows;  ///< Each with a cell for every column.
};

/// The table as text, see CsvTable.
std::string csv_text(const DataTable& table);

/// Columns of the fields visited that have a heading. Rows serve as examples: their values do not matter.
struct TableHead {
  std::vector<TableColumn>& columns;

  template <class Value>
  void operator()(const ResultField& f, const Value&) {
    if (f.heading.empty()) return;
    constexpr bool kNumber = std::is_same_v<Value, double> || std::is_same_v<Value, std::optional<double>>;
    const ShownUnit unit = shown_unit(f);
    columns.push_back({headed(f.heading, kNumber ? unit.name : ""), unit.digits});
  }
};

/// The cells of one row, in the units of the heads.
struct TableRow {
  std::vector<TableCell>& cells;

  void operator()(const ResultField& f, double value) { put(f, value * shown_unit(f).factor); }
  void operator()(const ResultField& f, const std::optional<double>& value) {
    if (value) {
      (*this)(f, *value);
    } else {
      put(f, std::monostate());
    }
  }
  void operator()(const ResultField& f, int value) { put(f, static_cast<double>(value)); }
  void operator()(const ResultField& f, const std::string& value) { put(f, value); }
  template <HasResultWords Enum>
  void operator()(const ResultField& f, const Enum& value) {
    put(f, std::string(word(value)));
  }

 private:
  void put(const ResultField& f, TableCell cell) {
    if (!f.heading.empty()) cells.push_back(std::move(cell));
  }
};

}  // namespace overbend
