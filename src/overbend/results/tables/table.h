/// A table as data: titles, units, decimals and cells, from which terminal, files, report, page and Python make their
/// own.
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

/// A number times `factor`, or a dash where there is none.
inline TableCell or_dash(const std::optional<double>& value, double factor = 1.0) {
  return value ? TableCell(factor * *value) : TableCell("-");
}

struct TableColumn {
  std::string title;             ///< Without the unit.
  std::string unit;              ///< That values are shown in; empty for plain numbers and words.
  double factor = 1.0;           ///< From SI to that unit.
  int digits = 3;                ///< Decimals shown, in that unit.
  bool words = false;            ///< A column of words: set flush left.
  std::string group = {};        ///< Head above neighbouring columns of the same group; empty: none.
  std::string key = {};          ///< Name of the quantity for scripts and the page; may be empty.
  std::string description = {};  ///< What it is, for a reader who points at the head; may be empty.

  /// A column of words.
  explicit TableColumn(std::string heading) : title(std::move(heading)), words(true) {}
  /// `decimals`: those of metric values. An SI unit without one to be read in, "%" and "" among them, is shown as it
  /// is.
  TableColumn(std::string heading, const ShownUnit& shown, int decimals);
  TableColumn(std::string heading, std::string_view si, int decimals);
  /// Of numbers that are texts already, because each has a unit or decimals of its own: set flush right.
  static TableColumn texts(std::string heading, std::string_view unit = "");
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
  std::string look = "plain";  ///< How it is set in report and page: "plain", "dense", "checks".
  std::vector<TableRow> rows = {};

  /// A column added on the right.
  Table& column(TableColumn column);
  /// Heads above the columns, from the left: title and number of columns that it spans.
  Table& groups(const std::vector<std::pair<std::string, int>>& spans);
  Table& row(std::vector<TableCell> cells, RowMark mark = RowMark::none);
  /// The columns with these keys, in their order; keys that no column has are passed over.
  Table with_columns(const std::vector<std::string_view>& keys) const;
  /// Leaves out the columns that say nothing in any row.
  Table& drop_empty_columns();
  bool empty() const { return rows.empty(); }
};

/// "top tension [kN]", or the title alone.
std::string title_with_unit(const TableColumn& column);

/// A number with the decimals of its column, never "-0.00"; "-" for what is not finite; "" for an empty cell.
std::string cell_text(const TableColumn& column, const TableCell& cell);

/// `{title, look, columns: [{title, unit, digits, words}], groups: [[title, span]], rows: [[cells]], marks: [mark]}`.
/// Numbers are in the units of the columns, with four decimals more than are shown, "-" where they are not finite;
/// `marks` is left out where no row stands out, a verdict is `{verdict, text}`, an empty cell null.
Json table_json(const Table& table);

/// The same with `key` and `description` of each column: for the page.
Json described_table_json(const Table& table);

/// The table as aligned columns of text without its title, `indent` blanks before each line: heads with their units,
/// then the rows. Nothing without rows.
std::string table_text(const Table& table, int indent = 2);

/// "over"; empty for none.
const char* name(RowMark mark);

}  // namespace overbend
