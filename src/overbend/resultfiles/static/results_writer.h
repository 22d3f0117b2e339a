/// Writes what a static analysis found: summary.json, pipe.csv, supports.csv, checks.csv, results.h5.
#pragma once

#include <filesystem>
#include <string>

#include "model/description/description.h"
#include "results/moored_dynamics.h"
#include "results/sensitivity_results.h"
#include "results/static_results.h"

namespace overbend {

/// Writes all files to `dir`, whole or not at all; makes `dir` where it is missing. Throws std::runtime_error when a
/// quantity is not finite (and names it) or a file cannot be written.
void write_static_results(const StaticResults& results, const Description& description,
                          const std::filesystem::path& dir);

/// The same files straight into an existing folder, for callers that stage a folder with further files of their
/// own. With `sensitivities` they say what the results hang on, and sensitivities.csv comes with them.
void write_static_files(const StaticResults& results, const Description& description,
                        const std::filesystem::path& folder, const SensitivityResults* sensitivities = nullptr);

/// checks.csv and calculation_sheet.csv into a folder.
void write_check_tables(const CheckTable& checks, const std::filesystem::path& folder);

/// moorings.csv and pull_ahead.csv into a folder, where the results have them. `in_time`: of a run from there.
void write_mooring_tables(const StaticResults& results, const std::vector<MooringLineDynamics>& in_time,
                          const std::filesystem::path& folder);

/// The text of pipe.csv: a row per station, engineering units.
std::string pipe_table(const StaticResults& results);

/// The text of supports.csv: a row per roller, engineering units.
std::string supports_table(const StaticResults& results);

/// Writes results.h5: groups model and static, and what results hang on where given.
void write_static_hdf5(const StaticResults& results, const Description& description, const std::filesystem::path& file,
                       const SensitivityResults* sensitivities = nullptr);

}  // namespace overbend
