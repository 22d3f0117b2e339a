/// One dynamic run into one folder: a realisation of the sea.
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
#include "study/run/peaks_of_history.h"
#include "study/run/prepared_case.h"

namespace overbend {

struct RealisationEnd : RunEnd {
  std::vector<HistoryPeaks> peaks{};        ///< Of a finished run that leaves no files.
  std::optional<DynamicResults> results{};  ///< Of the run; of one that was interrupted, of what lies behind t = 0.
};

/// Told of every row of histories as it is handed over: the columns and their values.
using RowWatch = std::function<void(const std::vector<HistoryColumn>& columns, std::span<const double> values)>;

/// Which files a run leaves.
enum class RunFiles { all, none };

/// Runs, or goes on where `resume` says so and there is something to go on from, and writes the files of results unless
/// none are wanted. Where it is stopped a checkpoint stays; where it fails nothing does. `writing` is held while files
/// are written, for the libraries below them may serve one thread alone. Throws std::runtime_error when the disk
/// refuses in the middle of the run.
RealisationEnd run_realisation(const PreparedCase& shared, const std::filesystem::path& folder, std::uint64_t seed,
                               bool resume, const std::function<DynamicControl(const DynamicProgress&)>& control,
                               FileLock& writing, const RowWatch& rows = {}, RunFiles files = RunFiles::all);

/// Writes results of an interrupted run as far as it went; its checkpoint stays, and a run taken up again writes its
/// own in their place. Throws std::runtime_error when the disk refuses.
void write_so_far(const PreparedCase& shared, DynamicResults results, const std::filesystem::path& folder,
                  FileLock& writing);

}  // namespace overbend
