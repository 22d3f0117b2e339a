/// What the checks of stored results can be made again with: which settings may differ from those of the analysis.
#pragma once

#include <string>

#include "model/model.h"
#include "results/dynamic_results.h"

namespace overbend {

/// The first key below `checks` by which the settings of the two models differ though the results do not hold what the
/// checks would need under those of `after`; empty where there is none. Of a static state that is what the current
/// adds; over time also everything that the largest utilisations of every station depend on, but the safety class.
std::string key_for_new_analysis(const Model& before, const Model& after, bool over_time);

/// Makes the largest utilisations of a safety class those of the run. They are exact: a run keeps them for every class.
void take_class(StationDesign& design, SafetyClass safety);

}  // namespace overbend
