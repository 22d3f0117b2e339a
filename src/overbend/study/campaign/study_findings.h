/// Inputs of a study that have no effect.
#pragma once

#include <string>
#include <vector>

#include "base/finding.h"
#include "study/cases/study_cases.h"

namespace overbend {

/// Returns warnings at varied keys that the models of the first, the middle and the last case have in common, such as a
/// key that the waves do not use, and seeds of a sea that is not random in any of them. Cases with an invalid model are
/// skipped.
Findings study_findings(const CaseBase& base, const StudyCases& cases);

}  // namespace overbend
