/// One stage of an operation on the line as a model of its own.
#pragma once

#include <string>
#include <variant>

#include "base/finding.h"
#include "model/description/description.h"
#include "study/run/run_ending.h"

namespace overbend {

/// The lay at the stage `wanted`, its number from 1 or its name, with the stage in its title. A tension that is sought
/// or follows from the bottom tension is found by solving the stages up to there. Otherwise how that ends: wrong_input
/// where the model has no such stage, no_solution where its tension cannot be found.
std::variant<Description, RunEnd> choose_stage(const Description& description, const std::string& wanted);

/// That the lay as such is computed though the model has an operation on the line. `choosable`: whether the analysis
/// could be of a stage instead.
Finding no_stage_finding(const Description& description, bool choosable = true);

}  // namespace overbend
