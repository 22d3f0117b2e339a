/// A table as data: titles, units, decimals and cells, common to terminal, files, report, page and Python.
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

/// A verdict: coloured if the output has colours.
struct VerdictCell {
  VerdictKind kind = VerdictKind::not_judged;
  std::string text;
};

using CellValue = std::variant<std::monostate, double, std::string, VerdictCell>;

/// A cell: a number in the SI unit of its column, a text, a verdict, or nothing.
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

/// Returns a number times `factor`, or a dash for a missing value.
inline TableCell or_dash(const std::optional<double>& value, double factor = 1.0) {
  return value ? TableCell(factor * *value) : TableCell("-");
}

struct TableColumn {
  std::string title;             ///< Without the unit.
  std::string unit;              ///< Unit in which values are shown; empty for plain numbers and texts.
  double factor = 1.0;           ///< Factor from SI to that unit.
  int digits = 3;                ///< Decimals shown, in that unit.
  bool is_text = false;          ///< True for a column of text, aligned left.
  std::string group = {};        ///< Common heading of neighbouring columns of the same group; empty: none.
  std::string key = {};          ///< Identifier of the quantity for scripts and the page; may be empty.
  std::string description = {};  ///< Description shown as a tooltip of the heading; may be empty.

  /// A column of text.
  explicit TableColumn(std::string heading) : title(std::move(heading)), is_text(true) {}
  /// `decimals`: those of metric values. An SI unit without a display unit, "%" and "" among them, is shown unchanged.
  TableColumn(std::string heading, const ShownUnit& shown, int decimals);
  TableColumn(std::string heading, std::string_view si, int decimals);
  /// Returns a column of numbers formatted as text, because each has a unit or decimals of its own: aligned right.
  static TableColumn texts(std::string heading, std::string_view unit = "");
};

/// Emphasis of a row.
enum class RowMark {
  none,
  over,    ///< Over a limit.
  soft,    ///< Reduced emphasis: informational, or not present.
  total,   ///< A sum below the others.
  loaded,  ///< Loaded row in a list of mostly unloaded ones.
};

struct TableRow {
  std::vector<TableCell> cells;  ///< One for each column.
  RowMark mark = RowMark::none;
};

struct Table {
  std::string title;  ///< Above the table; may be empty. In a workbook the name of the sheet.
  std::vector<TableColumn> columns;
  std::string look = "plain";  ///< Style in report and page: "plain", "dense", "checks".
  std::vector<TableRow> rows = {};

  /// Adds a column on the right.
  Table& column(TableColumn column);
  /// Sets the headings above the columns, from the left: title and number of columns spanned.
  Table& groups(const std::vector<std::pair<std::string, int>>& spans);
  Table& row(std::vector<TableCell> cells, RowMark mark = RowMark::none);
  /// Returns the columns with these keys, in the order of the keys; unknown keys are ignored.
  Table with_columns(const std::vector<std::string_view>& keys) const;
  /// Removes columns without a value in any row.
  Table& drop_empty_columns();
  bool empty() const { return rows.empty(); }
};

/// Returns "top tension [kN]", or the title alone.
std::string title_with_unit(const TableColumn& column);

/// Returns a number with the decimals of its column, never "-0.00"; "-" if it is not finite; "" for an empty cell.
std::string cell_text(const TableColumn& column, const TableCell& cell);

/// Returns `{title, look, columns: [{title, unit, digits, words}], groups: [[title, span]], rows: [[cells]], marks:
/// [mark]}`. Numbers are in the units of the columns, with four more decimals than shown, "-" if not finite; `marks` is
/// omitted if no row is marked, a verdict is `{verdict, text}`, an empty cell null.
Json table_json(const Table& table);

/// Returns the same with `key` and `description` of each column, for the page.
Json described_table_json(const Table& table);

/// Returns the table as aligned columns of text without its title, each line indented by `indent` blanks: headings with
/// units, then the rows. Empty without rows.
std::string table_text(const Table& table, int indent = 2);

/// Returns the name of the mark, such as "over"; empty for none.
const char* name(RowMark mark);

}  // namespace overbend
