/// Tables in text files: rows of cells between separators, comments after '#'.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"

namespace overbend {

struct TextRow {
  int line = 0;  ///< From 1.
  std::vector<std::string_view> cells;
};

/// Views into the source text, which must outlive the table.
struct TextTable {
  std::vector<TextRow> remarks;  ///< Comments: "# key: value" as two cells, others as one.
  std::vector<TextRow> rows;
};

/// Reads a regular file of at most 64 MB. Errors go to `diagnostics`, and nothing is returned. A workbook (XLSX),
/// another zip archive and text in UTF-16 are errors that name the remedy.
std::optional<std::string> read_text_file(const std::string& path, Diagnostics& diagnostics);

/// Splits a line at `separator`; a blank splits at white space of any length. Cells are trimmed. Without `quoted`,
/// quotes are characters like others; with it, a cell in double quotes may contain the separator and loses its quotes.
std::vector<std::string_view> split_line(std::string_view line, char separator, bool quoted);

/// Splits a comment, which starts with '#', as those of a table.
std::vector<std::string_view> split_remark(std::string_view line);

/// Splits at `separator`; a blank splits at white space of any length. Empty lines are skipped, cells are trimmed.
TextTable split_table(std::string_view text, char separator);

/// Parses a finite decimal number that fills the cell; nothing otherwise.
std::optional<double> cell_number(std::string_view cell);

}  // namespace overbend
