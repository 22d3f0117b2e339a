/// What a study is divided into among processes: its cases, or the rows of a chart of operability.
#pragma once

#include <filesystem>
#include <vector>

#include "study/cases/case_evaluation.h"

namespace overbend {

struct StudyUnits {
  std::size_t count = 0;            ///< Numbered from 0.
  std::vector<std::size_t> open;    ///< Without an answer.
  std::vector<std::size_t> failed;  ///< Their answer is that they failed.
};

/// As the records in the study's folder tell; all open where there is no folder.
StudyUnits study_units(const CaseBase& base, const std::filesystem::path& folder);

}  // namespace overbend
