/// Files of a lay table.
#pragma once

#include <filesystem>
#include <string>

#include "resultfiles/hdf5/dataset_sink.h"
#include "results/lay_table_results.h"
#include "results/tables/table.h"

namespace overbend {

/// Returns the rows and columns of lay-table.csv and lay-table.xlsx.
Table lay_table_data(const LayTable& table);

/// Returns the verdict on a row: "passed", "reserved", "exceeded", "not judged", "no lay".
std::string lay_verdict(const LayTableRow& row);

/// Writes the rows as datasets of the group /lay_table; SI, NaN for a row without a lay.
void write_lay_table_groups(DatasetSink& file, const LayTable& table);

/// Returns the text of summary.json; SI.
std::string lay_table_summary(const LayTable& table);

/// Writes lay-table.csv, lay-table.xlsx and summary.json into an existing folder. Throws std::runtime_error if a value
/// is not finite (and names it) or a file cannot be written.
void write_lay_table_files(const LayTable& table, const std::filesystem::path& folder);

}  // namespace overbend
