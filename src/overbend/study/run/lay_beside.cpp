#include "study/run/lay_beside.h"

#include <algorithm>
#include <iterator>

#include "statics/recovery/current_effect.h"
#include "study/run/static_run.h"

namespace overbend {
namespace {

/// `lay`: what the equilibrium itself starts from; the lay in still water, which has one, starts from that of `start`.
StaticRun solved(Model& model, const StaticSolution* lay, const LayStart* start, LayStart& found) {
  StaticRun statics;
  ModelEquilibrium outcome = solve_equilibrium(model, lay);
  if (outcome.failure) {
    statics.failure = std::move(outcome.failure);
    return statics;
  }
  statics.results = unjudged_statics(model, outcome);
  if (start != nullptr) found.still = start->still;
  judge_statics(model, *outcome.solution, *statics.results, found.still);
  found.lay = *outcome.solution;
  statics.solution = std::move(outcome.solution);
  return statics;
}

}  // namespace

bool pushed_sideways(const Model& model) {
  const Description& lay = model.description;
  return has_current(model) || lay.vessel.heel != 0.0 || lay.route.given() || lay.environment.seabed.slope != 0.0;
}

StaticRun solve_beside(Model& model, const std::vector<const LayStart*>& starts,
                       std::shared_ptr<const LayStart>* found) {
  std::vector<const LayStart*> tries;
  std::ranges::copy_if(starts, std::back_inserter(tries), [](const LayStart* one) { return one != nullptr; });
  if (tries.empty()) tries.push_back(nullptr);
  if (!model.description.has_pipe || is_moored_lay(model.description)) {
    return run_statics(model, tries.front() != nullptr ? &tries.front()->lay : nullptr);
  }
  StaticRun statics;
  const auto attempt = [&](const StaticSolution* lay, const LayStart* start) {
    auto next = std::make_shared<LayStart>();
    statics = solved(model, lay, start, *next);
    if (found != nullptr) *found = statics.failure ? nullptr : std::move(next);
    return !statics.failure || statics.failure->input;
  };
  const bool alone = pushed_sideways(model);
  if (alone && attempt(nullptr, tries.front())) return statics;
  for (const LayStart* start : tries) {
    if (alone && start == nullptr) continue;
    if (!attempt(start != nullptr ? &start->lay : nullptr, start)) continue;
    if (alone && statics.results) {
      statics.results->findings.push_back(
          {FindingCode::other_equilibrium_possible,
           "statics find no equilibrium from nothing; this one was reached from a lay beside it, and there may be "
           "others"});
    }
    break;
  }
  return statics;
}

}  // namespace overbend
