/// Estimate of the duration of a study from a few of its cases.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "study/cases/study_cases.h"

namespace overbend {

struct StudyProbe {
  double seconds = 0.0;               ///< Time of a case on one core [s]; 0 if none could be solved.
  double before = 0.0;                ///< Time before the first case [s].
  std::vector<std::string> failures;  ///< Cases of the probe without a solution.
};

/// Solves the first, the middle and the last case in a temporary folder. A dynamic analysis is stopped after some
/// seconds, and its total time is extrapolated from its progress.
StudyProbe probe_study(const CaseBase& base, const StudyCases& cases, const std::function<bool()>& stop);

}  // namespace overbend
