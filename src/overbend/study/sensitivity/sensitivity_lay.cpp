#include "study/sensitivity/sensitivity_lay.h"

#include <algorithm>

#include "checks/run_checks.h"
#include "mechanics/roller_contact.h"
#include "model/lay_stage.h"
#include "statics/recovery/current_effect.h"
#include "statics/recovery/recovery.h"

namespace overbend {
namespace {

bool same_pose(const VesselPose& a, const VesselPose& b) {
  return a.p_WV == b.p_WV && a.R_WV == b.R_WV;
}

/// What is the same at each of the steps, and much of what they cost: nothing of it moves a lay at rest.
Description only_statics(Description description) {
  description.findings.clear();
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

/// Both turned the other way.
std::vector<double> opposite(std::vector<double> turns) {
  for (double& turn : turns) turn = -turn;
  return turns;
}

/// Two changes of one equilibrium at once, to first order.
StaticSolution both(const StaticSolution& base, StaticSolution a, const StaticSolution& b) {
  for (std::size_t i = 0; i < a.state.q.size(); ++i) a.state.q[i] += b.state.q[i] - base.state.q[i];
  a.state.far_force += b.state.far_force - base.state.far_force;
  return a;
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
      stinger_(model, solution, pipe_),
      still_(still_lay(model, solution)),
      results_(recovered(model, solution, still_results())) {}

Model SensitivityLay::rebuilt(const Description& description, const std::vector<double>& turns) const {
  const std::optional<LayStageDescription>& stage = model_->description.stage;
  Model model = build_model(only_statics(stage ? at_stage(description, same_stage(description, *stage)) : description));
  if (held_) model.mean_pose = model_->mean_pose;
  set_stinger(model, *model_, turns);
  return model;
}

std::optional<ResultPair> SensitivityLay::follow(const Description& before, const Description& after) {
  Model low = rebuilt(before), high = rebuilt(after);
  std::optional<StaticPair> pipe = pipe_.follow(low, high);
  if (pipe && stinger_.turns()) {
    const std::vector<double> turns =
        stinger_.answer(0.5 * (stinger_.moments(high, pipe->after) - stinger_.moments(low, pipe->before)));
    low = rebuilt(before, opposite(turns));
    high = rebuilt(after, turns);
    pipe = pipe_.follow(low, high);
  }
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

std::optional<StaticPair> SensitivityLay::push_pipe(int roller, double force, Model& low, Model& high) {
  std::optional<StaticPair> pushed = pipe_.push(roller, force);
  if (!pushed || !stinger_.turns()) return pushed;
  Eigen::VectorXd moments =
      0.5 * (stinger_.moments(*model_, pushed->after) - stinger_.moments(*model_, pushed->before));
  const auto index = static_cast<std::size_t>(roller);
  const int section = model_->supports.boxes[static_cast<std::size_t>(model_->supports.rollers[index].box)].section;
  const ClosestPoint& closest = pipe_.system().contacts()[index].at;
  if (section >= 0) {  // the roller is pushed as hard as the pipe, the other way
    const Vec3 direction = roller_distance(pipe_.system().rollers().placed(roller), closest).direction;
    moments += stinger_.moments(static_cast<std::size_t>(section), {-force * direction, closest.place});
  }
  const std::vector<double> turns = stinger_.answer(moments);
  set_stinger(low, *model_, opposite(turns));
  set_stinger(high, *model_, turns);
  const std::optional<StaticPair> turned = pipe_.follow(low, high);
  if (!turned) return std::nullopt;
  return StaticPair{both(*solution_, pushed->before, turned->before), both(*solution_, pushed->after, turned->after),
                    turned->contacts_stay};
}

std::optional<ResultPair> SensitivityLay::push(int roller, double force, bool in_still) {
  Model low = *model_, high = *model_;
  const std::optional<StaticPair> moved =
      in_still ? still_->tangent.push(roller, force) : push_pipe(roller, force, low, high);
  if (!moved) return std::nullopt;
  ResultPair pair;
  if (!in_still) {
    pair.before = recovered(low, moved->before, still_results());
    pair.after = recovered(high, moved->after, still_results());
    return pair;
  }
  pair.still_before = recover_state(still_->model, moved->before);
  pair.still_after = recover_state(still_->model, moved->after);
  pair.before = recovered(*model_, *solution_, &*pair.still_before);
  pair.after = recovered(*model_, *solution_, &*pair.still_after);
  return pair;
}

}  // namespace overbend
