/// Tells apart what the steady current does to a static state.
#pragma once

#include "statics/statics.h"

namespace overbend {

/// Where the checks count the current as environmental load: solves the same lay in still water and gives every station
/// what the current adds, place by place along the pipe from the tensioner. Does nothing without a current; where the
/// still lay has no equilibrium it leaves a warning. `solution` is the equilibrium with the current, to start from.
void find_current_effect(const Model& model, const StaticSolution& solution, StaticResults& results);

}  // namespace overbend
