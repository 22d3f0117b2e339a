/// Statics with warm starts from solved lays.
#pragma once

#include <memory>

#include "study/run/static_analysis.h"

namespace overbend {

/// Solution from which neighbouring lays start.
struct LayWarmStart {
  StaticSolution lay;
  std::optional<StaticSolution> still_water;  ///< Lay in still water, if the checks need it.
};

/// True if something loads the lay sideways, so that side rollers may carry load and several equilibria may exist.
bool has_lateral_load(const Model& model);

/// Returns the equilibrium of the model and its results, as solve_model does: from the first of the starts, from
/// scratch if that fails, then from the other starts. Null starts are ignored.
///
/// A lay with lateral loads may have several equilibria, which differ in the side rollers that carry load. It is solved
/// from scratch, so that it is the equilibrium that a static analysis finds, and from another lay only if that fails; a
/// warning then says so. `found`, if not null, receives the start for the next lay; null without a solution.
StaticRun solve_with_warm_starts(Model& model, const std::vector<const LayWarmStart*>& starts,
                                 std::shared_ptr<const LayWarmStart>* found = nullptr);

}  // namespace overbend
