/// One dynamic run of one seed, stored in one folder.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/file_lock.h"
#include "recording/run_dynamics.h"
#include "study/run/history_peaks.h"
#include "study/run/prepared_case.h"

namespace overbend {

struct RealisationResult : RunResult {
  std::vector<HistoryPeaks> peaks{};        ///< Peaks of a finished run that leaves no files.
  std::optional<DynamicResults> results{};  ///< Results of the run; of an interrupted run, those from t = 0 on.
};

/// Called for every output row of the histories, with the columns and their values.
using RowCallback = std::function<void(const std::vector<HistoryColumn>& columns, std::span<const double> values)>;

/// Files that a run leaves in its folder.
enum class RunFiles { all, none };

/// Runs one realisation, or resumes it if `resume` is set and there is a checkpoint, and writes the files of results
/// unless `files` is none. A stopped run leaves a checkpoint, a failed run nothing. `writing` is held while files are
/// written, because the libraries below may serve one thread only. Throws std::runtime_error if the disk fails during
/// the run.
RealisationResult run_realisation(const PreparedCase& shared, const std::filesystem::path& folder, std::uint64_t seed,
                                  bool resume, const std::function<DynamicControl(const DynamicProgress&)>& control,
                                  FileLock& writing, const RowCallback& rows = {}, RunFiles files = RunFiles::all);

/// Writes the results of an interrupted run up to its present time. The checkpoint stays, and a resumed run replaces
/// these results by its own. Throws std::runtime_error if the disk fails.
void write_partial_results(const PreparedCase& shared, DynamicResults results, const std::filesystem::path& folder,
                           FileLock& writing);

}  // namespace overbend
