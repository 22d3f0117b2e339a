/// One stage of a lay operation as a model of its own.
#pragma once

#include <string>
#include <variant>

#include "base/finding.h"
#include "model/description/description.h"
#include "study/run/run_status.h"

namespace overbend {

/// Returns the lay at the stage `wanted`, given by its number from 1 or its name, with the stage in its title. A sought
/// tension, or one that follows from the bottom tension, is found by solving the preceding stages. Errors: wrong_input
/// if the model has no such stage, no_solution if its tension cannot be found.
std::variant<Description, RunResult> choose_stage(const Description& description, const std::string& wanted);

/// Returns the notice that the normal lay is computed although the model has a lay operation. `choosable`: the analysis
/// accepts a stage.
Finding no_stage_finding(const Description& description, bool choosable = true);

}  // namespace overbend
