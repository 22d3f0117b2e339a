/// A lay table: tension, lay-back or depth in steps, or the points of a route; and its files.
#pragma once

#include <filesystem>
#include <functional>

#include "model/description/description.h"
#include "results/lay_table_results.h"

namespace overbend {

/// Makes the table that is asked for; limits that are not given follow from the model's own lay. A row without an
/// equilibrium says why. What is varied gets rows for its least and largest value with every governing check passed,
/// also where they lie beyond the table. `told`, where given, hears of every row with the number of all that were asked
/// for; false from it ends the table.
LayTable make_lay_table(const Description& description, const LayTableDescription& asked,
                        const std::function<bool(const LayTableRow&, std::size_t of)>& told = {});

/// Writes lay-table.csv, lay-table.xlsx, summary.json and report.html, whole or not at all. Throws UnusableFolder
/// (runstore/staged_folder.h) when the folder cannot be.
void write_lay_table_run(const LayTable& table, const Description& description, const std::filesystem::path& folder);

}  // namespace overbend
