/// What a goal seek found, in files.
#pragma once

#include <filesystem>
#include <string>

#include "resultfiles/summary/summary_json.h"
#include "results/seek_results.h"

namespace overbend {

/// The key `seek` of summary.json. `answer`, `unit` and `slope` are single values for one key, objects by key for
/// several.
Json seek_json(const SeekResults& results);

/// The text of seek.csv: a row per model solved on the way, in the units that keys and results are shown in.
std::string seek_table(const SeekResults& results);

/// Adds seek.csv, and `seek` to the summary.json that lies in the folder; makes that where there is none, as after a
/// search without an answer.
void write_seek_files(const SeekResults& results, const std::string& title, const std::filesystem::path& folder);

}  // namespace overbend
