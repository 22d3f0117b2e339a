/// Tables and sentences of the page of a study. Each returns HTML; empty where there is nothing to say.
#pragma once

#include <string>

#include "results/study_results.h"

namespace overbend {

/// How many cases pass, exceed a check, could not be solved.
std::string study_verdict(const StudyResults& results);
/// What changes from case to case.
std::string study_inputs_section(const StudyResults& results);
/// Over the seeds, with confidence.
std::string study_extremes_section(const StudyResults& results);
/// Limit and governing check of every cell, and workability.
std::string operability_section(const StudyResults& results);
/// Reason and command of each.
std::string failed_cases_section(const StudyResults& results);
/// At most three hundred of them.
std::string study_cases_section(const StudyResults& results);

}  // namespace overbend
