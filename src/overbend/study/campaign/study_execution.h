/// A study from its first case to its tables.
#pragma once

#include <filesystem>

#include "study/campaign/study_runner.h"
#include "study/run/run_status.h"

namespace overbend {

struct StudyExecution : RunResult {
  StudyTally tally{};      ///< Numbers of cases; a limit search reports its analyses in the results.
  StudyResults results{};  ///< Results, if tables were written.
};

/// Runs the open cases of the study in the folder, or its limit search, and writes the tables. A folder with other
/// contents is wrong_input. Throws FileError if a record cannot be written.
StudyExecution execute_study(const CaseBase& base, const std::filesystem::path& folder, const StudyRunOptions& options,
                             StudyObserver& watch);

}  // namespace overbend
