/// Tables in text files: rows of cells between separators, remarks after '#'.
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

/// Views into the text it was made from, which must outlive it.
struct TextTable {
  std::vector<TextRow> remarks;  ///< "# key: value" as two cells, other remarks as one.
  std::vector<TextRow> rows;
};

/// The whole of a regular file, at most 64 MB. Errors go to `diagnostics` and nothing is returned.
std::optional<std::string> read_text_file(const std::string& path, Diagnostics& diagnostics);

/// Splits at `separator`; a blank splits at white space of any length. Empty lines are passed over, cells are trimmed.
TextTable split_table(std::string_view text, char separator);

/// A finite decimal number that fills the cell.
std::optional<double> cell_number(std::string_view cell);

}  // namespace overbend
