/// A search for limits on the terminal.
#pragma once

#include <string>

#include "study/operability/operability_study.h"

namespace overbend {

/// "12 limits to search (4 values of environment.waves.tp x 3 of environment.waves.from), 5 seeds each: 60 searches".
std::string limits_to_search(const OperabilityPlan& plan);

/// The values that are searched, in one line.
std::string search_line(const OperabilityPlan& plan);

/// An analysis of the search, in one line.
std::string trial_line(const OperabilityPlan& plan, const TrialTold& trial);

/// Limits on the terminal, a line per cell with what ends it.
std::string operability_lines(const OperabilityResults& results);

}  // namespace overbend
