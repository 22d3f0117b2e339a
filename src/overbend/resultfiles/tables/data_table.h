/// Tables in files: a table of typed cells as CSV.
#pragma once

#include <string>

#include "results/tables/table.h"

namespace overbend {

/// Returns the table as text, see CsvTable: numbers with all their digits, in the units of the headings.
std::string csv_text(const Table& table);

}  // namespace overbend
