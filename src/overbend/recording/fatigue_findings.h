/// Evaluation of the damage rates along the line: welds during their passage, standby, and remarks.
#pragma once

#include "checks/weld_path.h"
#include "model/model.h"
#include "results/dynamic_results.h"

namespace overbend {

/// Upper limit of the reported standby [s]: 100 years.
inline constexpr double kMaxStandby = 3.15576e9;

/// Returns the pace of laying.
LayPace lay_pace(const Description& description);

/// Fills the damage of welds during their passage and the remaining standby time, from the rates of the spots.
void add_weld_damage(const Model& model, DynamicResults& results);
/// Adds the assumptions of the fatigue calculation to the results.
void assume_of_fatigue(const Model& model, DynamicResults& results);
/// Warns of few stress cycles, of an exhausted fatigue budget and of yielding steel.
void warn_of_fatigue(const Model& model, DynamicResults& results);

}  // namespace overbend
