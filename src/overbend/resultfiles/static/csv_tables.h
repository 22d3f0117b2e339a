/// Headings and rows of pipe.csv and supports.csv, to which a dynamic analysis appends its own columns.
#pragma once

#include <string>
#include <vector>

#include "resultfiles/tables/csv_table.h"
#include "results/static_results.h"

namespace overbend {

/// Returns the headings of pipe.csv.
std::vector<std::string> pipe_head();
void pipe_cells(CsvTable& table, const StaticResults& results, const Station& station);

/// Returns the headings of supports.csv.
std::vector<std::string> supports_head();
/// `row` counts the rows of the support from 0; `roller` is one of that row.
void roller_cells(CsvTable& table, const StaticResults& results, const SupportResult& support, std::size_t row,
                  const RollerResult& roller);

}  // namespace overbend
