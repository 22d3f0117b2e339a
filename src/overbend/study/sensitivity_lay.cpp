#include "study/sensitivity_lay.h"

#include <algorithm>

#include "checks/run_checks.h"
#include "model/lay_stage.h"
#include "model/stinger_turn.h"
#include "statics/current_effect.h"
#include "statics/recovery.h"

namespace overbend {
namespace {

bool same_pose(const VesselPose& a, const VesselPose& b) {
  return a.p_WV == b.p_WV && a.R_WV == b.R_WV;
}

/// What is the same at each of the steps, and much of what they cost: nothing of it moves a lay at rest.
Description only_statics(Description description) {
  description.warnings.clear();
  description.source_text.clear();
  return description;
}

/// The same stage of the operation, as the description now has it; a tension that was sought stays.
LayStageDescription same_stage(const Description& description, const LayStageDescription& stage) {
  for (LayStageDescription& candidate : lay_stages(description)) {
    if (candidate.name != stage.name) continue;
    if (!candidate.tension) candidate.tension = stage.tension;
    return candidate;
  }
  return stage;
}

/// A stinger that the forces turn stays where it came to rest.
void hold_stinger(Model& model, const Model& at_rest) {
  const std::vector<StingerSectionDescription>& described = model.description.supports.sections;
  if (described.empty() || described.size() != at_rest.supports.sections.size()) return;
  std::vector<double> angles;
  for (std::size_t i = 0; i < described.size(); ++i) {
    const bool found = described[i].floats() && !described[i].angle;
    angles.push_back(found ? at_rest.supports.sections[i].angle : described[i].angle.value_or(0.0));
  }
  turn_stinger(model.supports, angles);
}

/// With the lay in still water, where there is one.
StaticResults recovered(const Model& model, const StaticSolution& solution, const StaticResults* still) {
  StaticResults results = recover_state(model, solution);
  if (still != nullptr) set_current_effect(still->stations, results);
  fill_checks(model, results);
  return results;
}

}  // namespace

SensitivityLay::Still::Still(Model made, StaticSolution found)
    : model(std::move(made)),
      solution(std::move(found)),
      tangent(model, solution),
      results(recover_state(model, solution)) {}

std::unique_ptr<SensitivityLay::Still> SensitivityLay::still_lay(const Model& model, const StaticSolution& solution) {
  if (!needs_still_lay(model)) return nullptr;
  Model still = without_current(model);
  StaticOutcome outcome = solve_still_lay(still, solution);
  if (!outcome.solution) return nullptr;
  return std::make_unique<Still>(std::move(still), std::move(*outcome.solution));
}

SensitivityLay::SensitivityLay(const Model& model, const StaticSolution& solution)
    : model_(&model),
      solution_(&solution),
      held_(!same_pose(model.mean_pose, model.drawn_pose)),
      pipe_(model, solution),
      still_(still_lay(model, solution)),
      results_(recovered(model, solution, still_results())) {}

Model SensitivityLay::rebuilt(const Description& description) const {
  const std::optional<LayStageDescription>& stage = model_->description.stage;
  Model model = build_model(only_statics(stage ? at_stage(description, same_stage(description, *stage)) : description));
  if (held_) model.mean_pose = model_->mean_pose;
  hold_stinger(model, *model_);
  return model;
}

std::optional<ResultPair> SensitivityLay::follow(const Description& before, const Description& after) {
  const Model low = rebuilt(before), high = rebuilt(after);
  const std::optional<StaticPair> pipe = pipe_.follow(low, high);
  if (!pipe) return std::nullopt;
  if (!still_) {
    return ResultPair{
        recovered(low, pipe->before, nullptr), recovered(high, pipe->after, nullptr), {}, {}, pipe->contacts_stay};
  }
  const Model still_low = without_current(low), still_high = without_current(high);
  const std::optional<StaticPair> still = still_->tangent.follow(still_low, still_high);
  if (!still) return std::nullopt;
  ResultPair pair;
  pair.still_before = recover_state(still_low, still->before);
  pair.still_after = recover_state(still_high, still->after);
  pair.before = recovered(low, pipe->before, &*pair.still_before);
  pair.after = recovered(high, pipe->after, &*pair.still_after);
  pair.contacts_stay = pipe->contacts_stay && still->contacts_stay;
  return pair;
}

std::optional<ResultPair> SensitivityLay::push(int roller, double force, bool in_still) {
  const std::optional<StaticPair> moved = in_still ? still_->tangent.push(roller, force) : pipe_.push(roller, force);
  if (!moved) return std::nullopt;
  ResultPair pair;
  if (!in_still) {
    pair.before = recovered(*model_, moved->before, still_results());
    pair.after = recovered(*model_, moved->after, still_results());
    return pair;
  }
  pair.still_before = recover_state(still_->model, moved->before);
  pair.still_after = recover_state(still_->model, moved->after);
  pair.before = recovered(*model_, *solution_, &*pair.still_before);
  pair.after = recovered(*model_, *solution_, &*pair.still_after);
  return pair;
}

}  // namespace overbend
