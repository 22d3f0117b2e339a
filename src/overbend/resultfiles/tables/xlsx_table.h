/// Tables as a workbook for spreadsheet programs.
#pragma once

#include <filesystem>
#include <vector>

#include "results/tables/table.h"

namespace overbend {

/// Writes the tables, each on a sheet of its own: the head in bold with its units and frozen, numbers as numbers with
/// the decimals of their column, verdicts in green or red. The same tables give the same bytes. Written beside the file
/// first and then renamed. Throws FileFault (runstore/append_file.h) where that fails.
void write_xlsx(const std::vector<Table>& tables, const std::filesystem::path& file);

}  // namespace overbend
