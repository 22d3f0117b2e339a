/// A study from its first case to its tables.
#pragma once

#include <filesystem>

#include "study/campaign/study_runner.h"
#include "study/run/run_ending.h"

namespace overbend {

struct WholeStudy : RunEnd {
  StudyTally tally{};      ///< Of cases; a search for limits tells its analyses in the results.
  StudyResults results{};  ///< Where tables were made.
};

/// Runs what is open of the study in the folder, its cases or its search for limits, and makes the tables. A folder of
/// something else is wrong_input. Throws FileFault where the disk refuses.
WholeStudy run_whole_study(const CaseBase& base, const std::filesystem::path& folder, const StudyRunOptions& options,
                           StudyWatch& watch);

}  // namespace overbend
