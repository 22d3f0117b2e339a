#include "python/statics_handle.h"

#include "python/python_errors.h"
#include "resultfiles/hdf5/hdf5_visitors.h"
#include "resultfiles/summary/result_objects.h"
#include "resultfiles/summary/summary_json.h"
#include "study/run/static_analysis.h"
#include "study/run/warm_start.h"
#include "study/stages/stage_choice.h"

namespace overbend {
namespace {

constexpr const char* kWarmStartMessage =
    "the equilibrium was found from the given start; if the pipe is loaded sideways there may be several, and the one "
    "found without a start may differ";

/// Returns the model at a stage; without a stage the normal lay, with a finding that no stage was chosen.
Description staged(const Description& description, const std::string& stage) {
  if (stage.empty()) {
    Description lay = description;
    lay.findings.push_back(no_stage_finding(description));
    return lay;
  }
  std::variant<Description, RunResult> chosen = choose_stage(description, stage);
  if (const RunResult* error = std::get_if<RunResult>(&chosen)) throw EndedRun(*error);
  return std::get<Description>(std::move(chosen));
}

}  // namespace

Description chosen_description(const ModelHandle& model, const std::string& stage) {
  const Description& description = model.description();
  if (stage.empty() && !is_lay_operation(description.operation.type)) return description;
  return staged(description, stage);
}

StaticsHandle::StaticsHandle(std::shared_ptr<ModelHandle> model, const std::string& stage, const StaticsHandle* start)
    : model_(std::move(model)), stage_(stage) {
  const bool plain = stage_.empty() && !is_lay_operation(model_->statics_description().operation.type);
  made_.emplace(build_model(plain ? model_->statics_description() : chosen_description(*model_, stage_)));
  const bool close = made_->description.has_pipe && start != nullptr && start->statics_.solution;
  if (!close || !take(solve_equilibrium(*made_, &*start->statics_.solution))) {
    made_.emplace(build_model(made_->description));  // restores the model after the failed attempt
    take(solve_equilibrium(*made_));
  } else {
    if (has_lateral_load(*made_)) {
      statics_.results->findings.push_back({FindingCode::other_equilibrium_possible, kWarmStartMessage});
    }
    still_water_solution_ = start->still_water_solution();
  }
  if (statics_.failure) throw SolveError(*statics_.failure);
}

/// Stores the results; returns false if there is no equilibrium.
bool StaticsHandle::take(ModelEquilibrium equilibrium) {
  statics_ = {};
  statics_.failure = std::move(equilibrium.failure);
  if (statics_.failure) return false;
  statics_.results = recover_without_checks(*made_, equilibrium);
  statics_.solution = std::move(equilibrium.solution);
  return true;
}

std::optional<StaticSolution> StaticsHandle::still_water_solution() const {
  const std::lock_guard<std::mutex> hold(mutex_);
  return still_water_solution_;
}

const StaticRun& StaticsHandle::complete_run() const {
  const std::lock_guard<std::mutex> hold(mutex_);
  if (is_complete_) return statics_;
  add_code_checks(*made_, *statics_.solution, *statics_.results, still_water_solution_);
  add_roller_friction_limits(*made_, *statics_.solution, *statics_.results);
  add_hull_results(*made_, *statics_.results);
  is_complete_ = true;
  return statics_;
}

Json StaticsHandle::summary(bool all) const {
  if (all) complete_run();
  const std::lock_guard<std::mutex> hold(mutex_);
  Json summary = static_summary_json(*statics_.results);
  return all ? with_objects(std::move(summary)) : summary;
}

std::shared_ptr<ResultTree> StaticsHandle::tree() const {
  auto tree = std::make_shared<ResultTree>();
  write_static_parts(*tree, *complete_run().results);
  return tree;
}

void StaticsHandle::save(const std::filesystem::path& folder) const {
  write_static_run(*complete_run().results, chosen_description(*model_, stage_), folder);
}

}  // namespace overbend
