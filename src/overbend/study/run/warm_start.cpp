#include "study/run/warm_start.h"

#include <algorithm>
#include <iterator>

#include "base/ranges.h"
#include "statics/recovery/current_effect.h"
#include "study/run/static_analysis.h"

namespace overbend {
namespace {

/// `lay` is the initial shape of the equilibrium; the lay in still water starts from that of `start`.
StaticRun solved(Model& model, const StaticSolution* lay, const LayWarmStart* start, LayWarmStart& found) {
  StaticRun statics;
  ModelEquilibrium outcome = solve_equilibrium(model, lay);
  if (outcome.failure) {
    statics.failure = std::move(outcome.failure);
    return statics;
  }
  statics.results = recover_without_checks(model, outcome);
  if (start != nullptr) found.still_water = start->still_water;
  add_code_checks(model, *outcome.solution, *statics.results, found.still_water);
  found.lay = *outcome.solution;
  statics.solution = std::move(outcome.solution);
  return statics;
}

}  // namespace

bool has_lateral_load(const Model& model) {
  const Description& lay = model.description;
  return has_current(model) || lay.vessel.heel != 0.0 || lay.route.given() || lay.environment.seabed.slope != 0.0;
}

StaticRun solve_with_warm_starts(Model& model, const std::vector<const LayWarmStart*>& starts,
                                 std::shared_ptr<const LayWarmStart>* found) {
  std::vector<const LayWarmStart*> tries;
  ranges::copy_if(starts, std::back_inserter(tries), [](const LayWarmStart* start) { return start != nullptr; });
  if (tries.empty()) tries.push_back(nullptr);
  if (!model.description.has_pipe || is_moored_lay(model.description)) {
    return run_statics(model, tries.front() != nullptr ? &tries.front()->lay : nullptr);
  }
  StaticRun statics;
  const auto attempt = [&](const StaticSolution* lay, const LayWarmStart* start) {
    auto next = std::make_shared<LayWarmStart>();
    statics = solved(model, lay, start, *next);
    if (found != nullptr) *found = statics.failure ? nullptr : std::move(next);
    return !statics.failure || statics.failure->input;
  };
  const bool alone = has_lateral_load(model);
  if (alone && attempt(nullptr, tries.front())) return statics;
  for (const LayWarmStart* start : tries) {
    if (alone && start == nullptr) continue;
    if (!attempt(start != nullptr ? &start->lay : nullptr, start)) continue;
    if (alone && statics.results) {
      statics.results->findings.push_back(
          {FindingCode::other_equilibrium_possible,
           "no equilibrium was found from scratch; this one was reached from a neighbouring lay, and there may be "
           "others"});
    }
    break;
  }
  return statics;
}

}  // namespace overbend
