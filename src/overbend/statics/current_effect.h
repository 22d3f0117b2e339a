/// Tells apart what the steady current does to a static state.
#pragma once

#include "statics/statics.h"

namespace overbend {

/// Where the checks count the current as environmental load: solves the same lay in still water and gives every station
/// what the current adds, place by place along the pipe from the tensioner. Does nothing without a current; where the
/// still lay has no equilibrium it leaves a warning. `solution` is the equilibrium with the current, to start from.
///
/// The parts of it by themselves are below.
void find_current_effect(const Model& model, const StaticSolution& solution, StaticResults& results);

/// The same; the lay in still water starts from `still` where there is one, and is left there.
void find_current_effect(const Model& model, const StaticSolution& solution, StaticResults& results,
                         std::optional<StaticSolution>& still);

/// Whether the checks of this model need the lay in still water.
bool needs_still_lay(const Model& model);
/// Whether water flows past the line.
bool has_current(const Model& model);
/// The same lay without its current.
Model without_current(const Model& model);
/// Gives every station what it has beyond the lay in still water.
void set_current_effect(const StaticResults& still, StaticResults& results);

}  // namespace overbend
