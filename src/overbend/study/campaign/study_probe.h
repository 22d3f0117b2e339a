/// How long a study takes, from a few of its cases.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "study/cases/study_cases.h"

namespace overbend {

struct StudyProbe {
  double seconds = 0.0;               ///< Of a case, on one core; 0 where none could be solved.
  double before = 0.0;                ///< Once, before the first case.
  std::vector<std::string> failures;  ///< Cases of the probe without a solution.
};

/// Solves the first, the middle and the last case into a folder that is thrown away. A dynamic analysis is cut off
/// after some seconds, and what it would take in all follows from how far it came.
StudyProbe probe_study(const CaseBase& base, const StudyCases& cases, const std::function<bool()>& stop);

}  // namespace overbend
