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

/// Removes contents that are the same at all steps and do not affect statics, but cost time.
Description only_statics(Description description) {
  description.findings.clear();
  description.source_text.clear();
  return description;
}

/// Returns the same stage of the operation in another description; a sought tension stays.
LayStageDescription same_stage(const Description& description, const LayStageDescription& stage) {
  for (LayStageDescription& candidate : lay_stages(description)) {
    if (candidate.name != stage.name) continue;
    if (!candidate.tension) candidate.tension = stage.tension;
    return candidate;
  }
  return stage;
}

/// Returns the turns with reversed sign.
std::vector<double> opposite(std::vector<double> turns) {
  for (double& turn : turns) turn = -turn;
  return turns;
}

/// Superposes two small changes of one equilibrium.
StaticSolution both(const StaticSolution& base, StaticSolution a, const StaticSolution& b) {
  for (std::size_t i = 0; i < a.state.q.size(); ++i) a.state.q[i] += b.state.q[i] - base.state.q[i];
  a.state.far_force += b.state.far_force - base.state.far_force;
  return a;
}

/// `still_water`: results of the lay in still water; null if not needed.
StaticResults recovered(const Model& model, const StaticSolution& solution, const StaticResults* still_water) {
  StaticResults results = recover_state(model, solution);
  if (still_water != nullptr) set_current_effect(still_water->stations, results);
  fill_checks(model, results);
  return results;
}

}  // namespace

SensitivityLay::StillWaterLay::StillWaterLay(Model made, StaticSolution found)
    : model(std::move(made)),
      solution(std::move(found)),
      tangent(model, solution),
      results(recover_state(model, solution)) {}

std::unique_ptr<SensitivityLay::StillWaterLay> SensitivityLay::make_still_water_lay(const Model& model,
                                                                                    const StaticSolution& solution) {
  if (!needs_still_water_lay(model)) return nullptr;
  Model still_water_model = without_current(model);
  StaticOutcome outcome = solve_still_water_lay(still_water_model, solution);
  if (!outcome.solution) return nullptr;
  return std::make_unique<StillWaterLay>(std::move(still_water_model), std::move(*outcome.solution));
}

SensitivityLay::SensitivityLay(const Model& model, const StaticSolution& solution)
    : model_(&model),
      solution_(&solution),
      held_(!same_pose(model.mean_pose, model.nominal_pose)),
      pipe_(model, solution),
      stinger_(model, solution, pipe_),
      still_water_(make_still_water_lay(model, solution)),
      results_(recovered(model, solution, still_water_results())) {}

Model SensitivityLay::rebuilt(const Description& description, const std::vector<double>& turns) const {
  const std::optional<LayStageDescription>& stage = model_->description.stage;
  Model model = build_model(
      only_statics(stage ? make_stage_description(description, same_stage(description, *stage)) : description));
  if (held_) model.mean_pose = model_->mean_pose;
  set_stinger(model, *model_, turns);
  return model;
}

std::optional<ResultPair> SensitivityLay::neighbouring_equilibria(const Description& before, const Description& after) {
  Model low = rebuilt(before), high = rebuilt(after);
  std::optional<StaticPair> pipe = pipe_.neighbouring_equilibria(low, high);
  if (pipe && stinger_.turns()) {
    const std::vector<double> turns =
        stinger_.compensating_turns(0.5 * (stinger_.moments(high, pipe->after) - stinger_.moments(low, pipe->before)));
    low = rebuilt(before, opposite(turns));
    high = rebuilt(after, turns);
    pipe = pipe_.neighbouring_equilibria(low, high);
  }
  if (!pipe) return std::nullopt;
  if (!still_water_) {
    return ResultPair{
        recovered(low, pipe->before, nullptr), recovered(high, pipe->after, nullptr), {}, {}, pipe->contacts_stay};
  }
  const Model still_water_low = without_current(low), still_water_high = without_current(high);
  const std::optional<StaticPair> still_water =
      still_water_->tangent.neighbouring_equilibria(still_water_low, still_water_high);
  if (!still_water) return std::nullopt;
  ResultPair pair;
  pair.still_water_before = recover_state(still_water_low, still_water->before);
  pair.still_water_after = recover_state(still_water_high, still_water->after);
  pair.before = recovered(low, pipe->before, &*pair.still_water_before);
  pair.after = recovered(high, pipe->after, &*pair.still_water_after);
  pair.contacts_stay = pipe->contacts_stay && still_water->contacts_stay;
  return pair;
}

std::optional<StaticPair> SensitivityLay::push_pipe(int roller, double force, Model& low, Model& high) {
  std::optional<StaticPair> pushed = pipe_.push(roller, force);
  if (!pushed || !stinger_.turns()) return pushed;
  Eigen::VectorXd moments =
      0.5 * (stinger_.moments(*model_, pushed->after) - stinger_.moments(*model_, pushed->before));
  const auto index = static_cast<std::size_t>(roller);
  const int section = model_->supports.boxes[static_cast<std::size_t>(model_->supports.rollers[index].box)].section;
  const ClosestPoint& closest = pipe_.system().contacts()[index].closest;
  if (section >= 0) {  // the roller receives the opposite force of the pipe
    const Vec3 direction = roller_distance(pipe_.system().rollers().placed(roller), closest).direction;
    moments += stinger_.moments(static_cast<std::size_t>(section), {-force * direction, closest.place});
  }
  const std::vector<double> turns = stinger_.compensating_turns(moments);
  set_stinger(low, *model_, opposite(turns));
  set_stinger(high, *model_, turns);
  const std::optional<StaticPair> turned = pipe_.neighbouring_equilibria(low, high);
  if (!turned) return std::nullopt;
  return StaticPair{both(*solution_, pushed->before, turned->before), both(*solution_, pushed->after, turned->after),
                    turned->contacts_stay};
}

std::optional<ResultPair> SensitivityLay::push(int roller, double force, bool in_still_water) {
  Model low = *model_, high = *model_;
  const std::optional<StaticPair> moved =
      in_still_water ? still_water_->tangent.push(roller, force) : push_pipe(roller, force, low, high);
  if (!moved) return std::nullopt;
  ResultPair pair;
  if (!in_still_water) {
    pair.before = recovered(low, moved->before, still_water_results());
    pair.after = recovered(high, moved->after, still_water_results());
    return pair;
  }
  pair.still_water_before = recover_state(still_water_->model, moved->before);
  pair.still_water_after = recover_state(still_water_->model, moved->after);
  pair.before = recovered(*model_, *solution_, &*pair.still_water_before);
  pair.after = recovered(*model_, *solution_, &*pair.still_water_after);
  return pair;
}

}  // namespace overbend
