/// The record of one analysis of a search for limits: the file trial.json in its folder.
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

/// Nothing where there is none, or where it answers another question.
std::optional<TrialRecord> read_trial(const std::filesystem::path& folder, const CaseQuestion& question);

/// Puts the record into the folder, which is made, whole or not at all. Throws FileFault when the disk refuses.
void write_trial(const TrialRecord& record, const CaseQuestion& question, const std::filesystem::path& folder);

}  // namespace overbend
