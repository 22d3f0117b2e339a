/// A table as data: titles, units, decimals and cells, from which terminal, files, report, page and Python make their own.
#pragma once

#include <concepts>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "base/json.h"
#include "base/shown_unit.h"
#include "results/verdict.h"

namespace overbend {

/// A verdict: shown in a colour where the reader has any.
struct VerdictCell {
  VerdictKind kind = VerdictKind::not_judged;
  std::string text;
};

using CellValue = std::variant<std::monostate, double, std::string, VerdictCell>;

/// A cell: a number in the SI unit of its column, words, a verdict, or nothing.
struct TableCell : CellValue {
  TableCell() = default;
  TableCell(double value) : CellValue(value) {}
  TableCell(std::integral auto value) : CellValue(static_cast<double>(value)) {}
  TableCell(const std::optional<double>& value) : CellValue(value ? CellValue(*value) : CellValue()) {}
  TableCell(std::string text) : CellValue(std::move(text)) {}
  TableCell(std::string_view text) : CellValue(std::string(text)) {}
  TableCell(const char* text) : CellValue(std::string(text)) {}
  TableCell(VerdictCell verdict) : CellValue(std::move(verdict)) {}
};

struct TableColumn {
  std::string title;    ///< Without the unit.
  std::string unit;     ///< That values are shown in; empty for plain numbers and words.
  double factor = 1.0;  ///< From SI to that unit.
  int digits = 3;       ///< Decimals shown, in that unit.
  bool words = false;   ///< A column of words: set flush left.

  /// A column of words.
  explicit TableColumn(std::string heading) : title(std::move(heading)), words(true) {}
  /// `decimals`: those of metric values. An SI unit without one to be read in, "%" and "" among them, is shown as it is.
  TableColumn(std::string heading, const ShownUnit& shown, int decimals);
  TableColumn(std::string heading, std::string_view si, int decimals);
};

/// How a row stands out.
enum class RowMark {
  none,
  over,    ///< Beyond a limit.
  soft,    ///< Of less weight: for information, not there.
  total,   ///< A sum below the others.
  loaded,  ///< Of a list where most carry nothing.
};

struct TableRow {
  std::vector<TableCell> cells;  ///< One for every column.
  RowMark mark = RowMark::none;
};

struct Table {
  std::string title;  ///< Above the table; may be empty. Of a workbook the name of the sheet.
  std::vector<TableColumn> columns;
  std::vector<std::pair<std::string, int>> groups = {};  ///< A head above the columns: title, number of columns.
  std::vector<TableRow> rows = {};
  std::string look = "plain";  ///< How it is set in report and page: "plain", "dense", "checks".

  Table& row(std::vector<TableCell> cells, RowMark mark = RowMark::none);
  bool empty() const { return rows.empty(); }
};

/// "top tension [kN]", or the title alone.
std::string title_with_unit(const TableColumn& column);

/// A number with the decimals of its column, never "-0.00"; "-" for what is not finite; "" for an empty cell.
std::string cell_text(const TableColumn& column, const TableCell& cell);

/// `{title, look, columns: [{title, unit, digits, words}], groups: [[title, span]], rows: [[cells]], marks: [mark]}`.
/// Numbers are in the units of the columns, with two decimals more than are shown; `marks` is left out where no row
/// stands out, a verdict is `{verdict, text}`, an empty cell null.
Json table_json(const Table& table);

/// The table as aligned columns of text, `indent` blanks before each line: heads with their units, then the rows.
std::string table_text(const Table& table, int indent = 2);

/// "over"; empty for none.
const char* name(RowMark mark);

}  // namespace overbend
