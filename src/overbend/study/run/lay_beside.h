/// Statics of a lay beside another one that is solved already.
#pragma once

#include <memory>

#include "study/run/static_run.h"

namespace overbend {

/// What lays close by start from.
struct LayStart {
  StaticSolution lay;
  std::optional<StaticSolution> still;  ///< In still water, where the checks need that.
};

/// Whether something pushes the lay sideways, so that side rollers may bear and there may be several equilibria.
bool pushed_sideways(const Model& model);

/// The equilibrium of the model and its results, as solve_model gives them: from the first of the starts, from nothing
/// where that does not serve, and where neither way leads to one from the other starts. Null ones are left out.
///
/// A lay that something pushes sideways may have several equilibria, which differ in the side rollers that bear: it is
/// solved from nothing, so that it is the one that statics by themselves find, and from another lay only where that
/// fails, which a warning says. `found`, where given, becomes what the next may start from; null without a lay.
StaticRun solve_beside(Model& model, const std::vector<const LayStart*>& starts,
                       std::shared_ptr<const LayStart>* found = nullptr);

}  // namespace overbend
