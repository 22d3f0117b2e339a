/// Writes the results of several realisations of a sea state: summary.json and seeds.csv.
#pragma once

#include <filesystem>
#include <string>

#include "base/json.h"
#include "base/shown_unit.h"
#include "results/seeds_results.h"
#include "results/static_results.h"

namespace overbend {

/// Writes both files into an existing folder. Throws std::runtime_error if a value is not finite (and names it) or a
/// file cannot be written.
void write_seeds_files(const StaticResults& statics, const SeedsResults& results, const std::filesystem::path& folder);

/// Returns the display unit of a quantity; plain numbers have a dash.
ShownUnit table_unit(const SeedQuantity& quantity);

/// Returns the most severe verdict of the runs; not judged if a run has failed or there is none, unless one is
/// exceeded.
VerdictKind worst_verdict(const SeedsResults& results);

/// Returns the key `seeds` of summary.json.
Json seeds_json(const SeedsResults& results);

/// Returns the text of summary.json: the static summary, and the key `seeds`.
std::string seeds_summary(const StaticResults& statics, const SeedsResults& results);

/// Throws std::runtime_error that names the first value that is not finite.
void require_finite(const SeedsResults& results);

/// Returns the text of seeds.csv: a row per seed, engineering units; values of a failed run are empty.
std::string seeds_table(const SeedsResults& results);

}  // namespace overbend
