/// Load effect of the steady current in a static state.
#pragma once

#include "statics/solver/statics.h"

namespace overbend {

/// If the checks treat the current as an environmental load: solves the same lay in still water and gives every station
/// the contribution of the current, by distance from the tensioner. Does nothing without a current; adds a warning if
/// the lay in still water has no equilibrium. `solution`: equilibrium with the current; its shape in the plane of the
/// route is the warm start.
///
/// Its parts are declared below.
void find_current_effect(const Model& model, const StaticSolution& solution, StaticResults& results);

/// Same; the lay in still water has a warm start from `still_solution` if given, and is returned in it.
void find_current_effect(const Model& model, const StaticSolution& solution, StaticResults& results,
                         std::optional<StaticSolution>& still_water_solution);

/// True if the checks of this model need the lay in still water.
bool needs_still_water_lay(const Model& model);
/// True if the current is not zero.
bool has_current(const Model& model);
/// Returns the same lay without current.
Model without_current(const Model& model);
/// Solves `still_model`, the model of a solution without its current. `still_solution`: solution in still water of a
/// neighbouring lay for a warm start, if any.
StaticOutcome solve_still_water_lay(const Model& still_water_model, const StaticSolution& solution,
                                    const StaticSolution* still_water_solution = nullptr);
/// Sets the contribution of the current in every station: its difference from the lay in still water.
void set_current_effect(const std::vector<Station>& still_water_stations, StaticResults& results);

}  // namespace overbend
