/// Tables as a workbook for spreadsheet programs.
#pragma once

#include <filesystem>
#include <vector>

#include "results/tables/table.h"

namespace overbend {

/// Writes the tables, each on its own sheet: the heading in bold with its units and frozen, numbers as numbers with the
/// decimals of their column, verdicts in green or red. The same tables give the same bytes. Written to a temporary file
/// in the same folder, then renamed. Throws FileError (runstore/append_file.h) on failure.
void write_xlsx(const std::vector<Table>& tables, const std::filesystem::path& file);

}  // namespace overbend
