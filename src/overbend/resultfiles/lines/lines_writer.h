/// Writes what was found of lines by themselves: summary.json, lines.csv, results.h5.
#pragma once

#include <filesystem>
#include <string>

#include "model/description/description.h"
#include "resultfiles/hdf5/dataset_sink.h"
#include "results/line_results.h"
#include "results/seeds_results.h"

namespace overbend {

/// The text of summary.json: static.lines and, where there was a run, dynamic.lines. SI.
std::string lines_summary(const LinesResults& results);

/// The group /lines.
void write_lines_groups(DatasetSink& file, const LinesResults& results);

/// The text of lines.csv: a row per node of every line, engineering units.
std::string lines_table(const LinesResults& results);

/// All files straight into an existing folder. Throws std::runtime_error when one cannot be written.
void write_lines_files(const LinesResults& results, const Description& description,
                       const std::filesystem::path& folder);

/// Of several seeds: summary.json with static.lines and `seeds`, and seeds.csv, straight into an existing folder.
/// `one`: the results of one of them. Throws std::runtime_error when a value is not finite or a file cannot be written.
void write_lines_seeds(const LinesResults& one, const SeedsResults& seeds, const std::filesystem::path& folder);

}  // namespace overbend
