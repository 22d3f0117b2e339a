/// Repetition of the code checks on stored results: settings that may differ from those of the analysis.
#pragma once

#include <string>

#include "model/model.h"
#include "results/dynamic_results.h"

namespace overbend {

/// Returns the first key below `checks` that differs between the two models and needs load effects that the results do
/// not contain; empty if there is none. For a static state these are the contributions of the current; over time also
/// everything that affects the maximum utilisations of every station, except the safety class.
std::string key_for_new_analysis(const Model& before, const Model& after, bool over_time);

/// Selects the stored maximum utilisations of a safety class. They are exact: a run stores them for every class.
void select_safety_class(StationDesign& design, SafetyClass safety);

}  // namespace overbend
