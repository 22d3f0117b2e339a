/// Tables and sentences of the page of a study; empty without content.
#pragma once

#include "report/page/blocks.h"
#include "results/study_results.h"
#include "results/verdict.h"

namespace overbend {

/// Returns the verdict with the numbers of cases that pass, exceed a check, or have no solution.
Verdict study_verdict(const StudyResults& results);
/// Returns the inputs that vary between cases.
Blocks study_inputs_section(const StudyResults& results);
/// Returns the extremes over the seeds, with confidence intervals.
Blocks study_extremes_section(const StudyResults& results);
/// Returns limit and governing check of every cell, and workability.
Blocks operability_section(const StudyResults& results);
/// Returns the reason and the command of each failed case.
Blocks failed_cases_section(const StudyResults& results);
/// Returns at most three hundred cases.
Blocks study_cases_section(const StudyResults& results);

}  // namespace overbend
