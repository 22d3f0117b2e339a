/// A search for limits on the terminal.
#pragma once

#include <string>

#include "study/operability_study.h"

namespace overbend {

/// What is going to be searched, in one line.
std::string search_line(const OperabilityPlan& plan);

/// An analysis of the search, in one line.
std::string trial_line(const OperabilityPlan& plan, const TrialTold& trial);

/// Limits on the terminal, a line per cell with what ends it.
std::string operability_lines(const OperabilityResults& results);

}  // namespace overbend
