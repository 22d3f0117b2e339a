/// Writes the results of a dynamic analysis: summary.json, pipe.csv, supports.csv, impacts.csv, checks.csv, results.h5;
/// for a hull without a pipe summary.json, moorings.csv, results.h5.
#pragma once

#include <filesystem>
#include <string>

#include "model/description/description.h"
#include "results/dynamic_results.h"
#include "results/static_results.h"
#include "runstore/run_store.h"

namespace overbend {

/// Writes the files into an existing folder, for callers that stage one (staged_folder.h) with further files. Long data
/// are copied from the store to results.h5 in blocks. Throws std::runtime_error if a quantity is not finite (and names
/// it) or a file cannot be written; some of the files may exist then.
void write_dynamic_files(const StaticResults& statics, const DynamicResults& dynamics, const RunStore& store,
                         const Description& description, const std::filesystem::path& folder);

/// Writes the same files for results whose checks were repeated; everything else, including the long data, is copied
/// from the results.h5 `from`.
void write_rechecked_files(const StaticResults& statics, const DynamicResults& dynamics,
                           const std::filesystem::path& from, const Description& description,
                           const std::filesystem::path& folder);

/// Returns the text of summary.json: that of the static analysis and the key `dynamic`.
std::string dynamic_summary(const StaticResults& statics, const DynamicResults& dynamics);

/// Returns the text of pipe.csv: that of the static analysis and envelopes, interpolated in arc length from the dynamic
/// stations.
std::string dynamic_pipe_table(const StaticResults& statics, const DynamicResults& dynamics);

/// Returns the text of supports.csv: that of the static analysis and the statistics of each roller.
std::string dynamic_supports_table(const StaticResults& statics, const DynamicResults& dynamics);

/// Returns the text of impacts.csv: the impacts with the largest forces, a row each, engineering units.
std::string impacts_table(const DynamicResults& dynamics);

/// Writes results.h5: groups model, static and dynamic.
void write_dynamic_hdf5(const StaticResults& statics, const DynamicResults& dynamics, const RunStore& store,
                        const Description& description, const std::filesystem::path& file);

}  // namespace overbend
