/// The record of one analysis of a limit search: the file trial.json in its folder.
#pragma once

#include <filesystem>
#include <optional>

#include "study/cases/case_evaluation.h"
#include "study/operability/operability_search.h"

namespace overbend {

struct TrialRecord {
  TrialResult result;
  double wall_time = 0.0;  ///< [s]
};

/// Empty if there is no record, or if it has other inputs.
std::optional<TrialRecord> read_trial(const std::filesystem::path& folder, const CaseInput& question);

/// Writes the record into the folder, which is created, completely or not at all. Throws FileError if the disk fails.
void write_trial(const TrialRecord& record, const CaseInput& question, const std::filesystem::path& folder);

}  // namespace overbend
