/// Text of an operability search for the terminal.
#pragma once

#include <string>

#include "study/operability/operability_study.h"

namespace overbend {

/// Returns a text such as "12 limits to search (4 values of environment.waves.tp x 3 of environment.waves.from), 5
/// seeds each: 60 searches".
std::string limits_to_search(const OperabilityPlan& plan);

/// Returns one line with the values searched.
std::string search_line(const OperabilityPlan& plan);

/// Returns one line on an analysis of the search.
std::string trial_line(const OperabilityPlan& plan, const TrialReport& trial);

/// Returns a line per cell with its limit and the governing criterion.
std::string operability_lines(const OperabilityResults& results);

}  // namespace overbend
