/// Writes what several realisations of a sea state gave together: summary.json and seeds.csv.
#pragma once

#include <filesystem>
#include <string>

#include "base/json.h"
#include "base/shown_unit.h"
#include "results/seeds_results.h"
#include "results/static_results.h"

namespace overbend {

/// Both files into an existing folder. Throws std::runtime_error when a value is not finite (and names it) or a file
/// cannot be written.
void write_seeds_files(const StaticResults& statics, const SeedsResults& results, const std::filesystem::path& folder);

/// What people read a quantity in; plain numbers have a dash.
ShownUnit table_unit(const SeedQuantity& quantity);

/// The most severe of the runs; not judged where a run has failed or there is none, unless one is exceeded.
VerdictKind worst_verdict(const SeedsResults& results);

/// What the key `seeds` of summary.json holds.
Json seeds_json(const SeedsResults& results);

/// The text of summary.json: what statics writes, and the key `seeds`.
std::string seeds_summary(const StaticResults& statics, const SeedsResults& results);

/// Throws std::runtime_error when a value is not finite, and names it.
void require_finite(const SeedsResults& results);

/// The text of seeds.csv: a row per seed, engineering units; values of a failed one stay empty.
std::string seeds_table(const SeedsResults& results);

}  // namespace overbend
