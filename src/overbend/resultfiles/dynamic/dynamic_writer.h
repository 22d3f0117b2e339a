/// Writes what a dynamic analysis found: summary.json, pipe.csv, supports.csv, impacts.csv, checks.csv, results.h5; of
/// a hull without a pipe summary.json, moorings.csv, results.h5.
#pragma once

#include <filesystem>
#include <string>

#include "model/description/description.h"
#include "results/dynamic_results.h"
#include "results/static_results.h"
#include "runstore/run_store.h"

namespace overbend {

/// Writes the files into an existing folder, for callers that stage one (staged_folder.h) with further files of
/// their own. Long data go from the store to results.h5 in blocks. Throws std::runtime_error when a quantity is not
/// finite (and names it) or a file cannot be written; some of the files may stand then.
void write_dynamic_files(const StaticResults& statics, const DynamicResults& dynamics, const RunStore& store,
                         const Description& description, const std::filesystem::path& folder);

/// The same of results whose checks were made again; everything else, long data with it, is that of the results.h5
/// `from`.
void write_rechecked_files(const StaticResults& statics, const DynamicResults& dynamics,
                           const std::filesystem::path& from, const Description& description,
                           const std::filesystem::path& folder);

/// The text of summary.json: what statics writes, and the key `dynamic`.
std::string dynamic_summary(const StaticResults& statics, const DynamicResults& dynamics);

/// The text of pipe.csv: what statics writes, and envelopes, interpolated in arc length from the stations of dynamics.
std::string dynamic_pipe_table(const StaticResults& statics, const DynamicResults& dynamics);

/// The text of supports.csv: what statics writes, and what each roller saw over time.
std::string dynamic_supports_table(const StaticResults& statics, const DynamicResults& dynamics);

/// The text of impacts.csv: the hardest impacts, a row each, engineering units.
std::string impacts_table(const DynamicResults& dynamics);

/// Writes results.h5: groups model, static and dynamic.
void write_dynamic_hdf5(const StaticResults& statics, const DynamicResults& dynamics, const RunStore& store,
                        const Description& description, const std::filesystem::path& file);

}  // namespace overbend
