/// Layout of tables as instruments, surveys and spreadsheets export them: separator, decimal sign, quotes, a line of
/// units, empty columns at the end of lines.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "base/diagnostics.h"
#include "seafiles/text_table.h"

namespace overbend {

/// A table with a recognised layout. `rows` starts with the header if there is one; lines without any cell are left
/// out. Quotes are removed, and decimal commas are decimal points.
struct ExportedTable : TextTable {
  char separator = ',';        ///< ',', ';', tab, or ' ' for white space of any length.
  bool decimal_comma = false;  ///< True if the file has decimal commas.
  bool has_header = false;     ///< True if the first cell of the first row is no number.
  TextRow units;               ///< Line of units below the header; without cells if there is none.
  /// Number of columns: of the header without empty cells at its end.
  std::size_t width = 0;
  std::shared_ptr<const std::string> text;  ///< Text with decimal points, if it had commas.

  /// Returns the unit of a column in the line of units; empty without one.
  std::string_view unit(std::size_t column) const;
};

/// Recognises the layout of `text` and splits it. Separators are looked for in this order: tab, semicolon, comma,
/// blank; decimal commas need another separator than the comma. Empty cells beyond the columns of the header are
/// dropped. `text` must outlive the table and `path` names it in messages. Reports an error and returns nothing if
/// decimal commas and decimal points are mixed, or commas may be decimal commas or thousands separators.
std::optional<ExportedTable> read_exported_table(std::string_view text, const std::string& path,
                                                 Diagnostics& diagnostics);

/// Returns a hint for a row with more cells than the table has columns: decimal commas between commas; empty otherwise.
std::string row_width_hint(const ExportedTable& table, const TextRow& row);

/// Reports a conversion or an interpretation of a file as a note (FindingCode::input_converted).
void add_notice(Diagnostics& diagnostics, const std::string& path, int line, std::string message);

}  // namespace overbend
