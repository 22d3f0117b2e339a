/// Tables and sentences of the page of a study; empty where there is nothing to say.
#pragma once

#include "report/page/blocks.h"
#include "results/study_results.h"
#include "results/verdict.h"

namespace overbend {

/// How many cases pass, exceed a check, could not be solved.
Verdict study_verdict(const StudyResults& results);
/// What changes from case to case.
Blocks study_inputs_section(const StudyResults& results);
/// Over the seeds, with confidence.
Blocks study_extremes_section(const StudyResults& results);
/// Limit and governing check of every cell, and workability.
Blocks operability_section(const StudyResults& results);
/// Reason and command of each.
Blocks failed_cases_section(const StudyResults& results);
/// At most three hundred of them.
Blocks study_cases_section(const StudyResults& results);

}  // namespace overbend
