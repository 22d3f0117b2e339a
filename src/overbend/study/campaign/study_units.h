/// Units into which a study is divided among processes: its cases, or the rows of an operability chart.
#pragma once

#include <filesystem>
#include <vector>

#include "study/cases/case_evaluation.h"

namespace overbend {

struct StudyUnits {
  std::size_t count = 0;            ///< Number of units, numbered from 0.
  std::vector<std::size_t> open;    ///< Units without a result.
  std::vector<std::size_t> failed;  ///< Units that have failed.
};

/// Reads the units from the records in the study's folder; all are open if there is no folder.
StudyUnits study_units(const CaseBase& base, const std::filesystem::path& folder);

}  // namespace overbend
