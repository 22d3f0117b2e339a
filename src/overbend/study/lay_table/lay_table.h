/// A lay table: tension, lay-back or depth in steps, or the points of a route; and its files.
#pragma once

#include <filesystem>
#include <functional>

#include "model/description/description.h"
#include "results/lay_table_results.h"

namespace overbend {

/// Calculates the requested table; limits that are not given follow from the model's own lay. A row without an
/// equilibrium holds the reason. The varied quantity gets rows for its minimum and maximum with every governing check
/// passed, also beyond the range of the table. `on_row`, if given, is called after every row with the total number of
/// requested rows; false ends the table.
LayTable make_lay_table(const Description& description, const LayTableDescription& asked,
                        const std::function<bool(const LayTableRow&, std::size_t of)>& on_row = {});

/// Writes lay-table.csv, lay-table.xlsx, summary.json and report.html, whole or not at all. Throws UnusableFolder
/// (runstore/staged_folder.h) when the folder cannot be.
void write_lay_table_run(const LayTable& table, const Description& description, const std::filesystem::path& folder);

}  // namespace overbend
