/// Tells apart what the steady current does to a static state.
#pragma once

#include "statics/solver/statics.h"

namespace overbend {

/// Where the checks count the current as environmental load: solves the same lay in still water and gives every station
/// what the current adds, place by place along the pipe from the tensioner. Does nothing without a current; where the
/// still lay has no equilibrium it leaves a warning. `solution` is the equilibrium with the current, to start from: its
/// shape laid into the plane of the route.
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
/// The equilibrium of `still_model`, the model of a solution without its current. From `still`, where there is one:
/// that of a lay close by.
StaticOutcome solve_still_lay(const Model& still_model, const StaticSolution& solution,
                              const StaticSolution* still = nullptr);
/// Gives every station what it has beyond the stations of the lay in still water.
void set_current_effect(const std::vector<Station>& still, StaticResults& results);

}  // namespace overbend
