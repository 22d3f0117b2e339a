/// What of a study changes nothing.
#pragma once

#include <string>
#include <vector>

#include "base/finding.h"
#include "study/cases/study_cases.h"

namespace overbend {

/// What the models of the first, the middle and the last case are all warned of at a key that the study varies, such as
/// a key that the waves do not use, and seeds of a sea that is not random in any of them. Cases that are no model are
/// passed over.
Findings study_findings(const CaseBase& base, const StudyCases& cases);

}  // namespace overbend
