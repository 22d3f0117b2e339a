/// Results of a goal seek in files.
#pragma once

#include <filesystem>
#include <string>

#include "resultfiles/summary/summary_json.h"
#include "results/seek_results.h"

namespace overbend {

/// Returns the key `seek` of summary.json. `answer`, `unit` and `slope` are single values for one key, objects by key
/// for several.
Json seek_json(const SeekResults& results);

/// Returns the text of seek.csv: a row per model evaluated, in the display units of keys and results.
std::string seek_table(const SeekResults& results);

/// Adds seek.csv, and `seek` to the summary.json of the folder; creates it if there is none, as after a search without
/// an answer.
void write_seek_files(const SeekResults& results, const std::string& title, const std::filesystem::path& folder);

}  // namespace overbend
