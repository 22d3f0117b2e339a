/// Writes the results of a static analysis: summary.json, pipe.csv, supports.csv, checks.csv, results.h5.
#pragma once

#include <filesystem>
#include <string>

#include "model/description/description.h"
#include "results/moored_dynamics.h"
#include "results/sensitivity_results.h"
#include "results/static_results.h"

namespace overbend {

/// Writes all files to `dir`, completely or not at all; creates `dir` if missing. Throws std::runtime_error if a
/// quantity is not finite (and names it) or a file cannot be written.
void write_static_results(const StaticResults& results, const Description& description,
                          const std::filesystem::path& dir);

/// Writes the same files directly into an existing folder, for callers that stage a folder with further files.
/// `sensitivities` are included if given, with sensitivities.csv.
void write_static_files(const StaticResults& results, const Description& description,
                        const std::filesystem::path& folder, const SensitivityResults* sensitivities = nullptr);

/// Writes checks.csv and calculation_sheet.csv into a folder.
void write_check_tables(const CheckTable& checks, const std::filesystem::path& folder);

/// Writes moorings.csv and pull_ahead.csv into a folder, if the results have them. `in_time`: results of a run from
/// this state.
void write_mooring_tables(const StaticResults& results, const std::vector<MooringLineDynamics>& in_time,
                          const std::filesystem::path& folder);

/// Returns the text of pipe.csv: a row per station, engineering units.
std::string pipe_table(const StaticResults& results);

/// Returns the text of supports.csv: a row per roller, engineering units.
std::string supports_table(const StaticResults& results);

/// Writes results.h5: groups model and static, and sensitivities if given.
void write_static_hdf5(const StaticResults& results, const Description& description, const std::filesystem::path& file,
                       const SensitivityResults* sensitivities = nullptr);

}  // namespace overbend
