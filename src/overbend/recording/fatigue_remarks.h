/// What follows from the damage rates along the line: welds on their way, standby, and what is to be said of it.
#pragma once

#include "checks/weld_path.h"
#include "model/model.h"
#include "results/dynamic_results.h"

namespace overbend {

/// Standby is told up to this time [s]: 100 years.
inline constexpr double kLongestStandby = 3.15576e9;

/// How the model lays.
LayPace lay_pace(const Description& description);

/// Fills in what welds gather on their way and what is left for standby, from the rates of the spots.
void follow_welds(const Model& model, DynamicResults& results);
void assume_of_fatigue(const Model& model, DynamicResults& results);
void warn_of_fatigue(const Model& model, DynamicResults& results);

}  // namespace overbend
