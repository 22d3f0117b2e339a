#include "python/statics_handle.h"

#include "python/python_errors.h"
#include "resultfiles/hdf5/hdf5_visitors.h"
#include "resultfiles/summary/result_objects.h"
#include "resultfiles/summary/summary_json.h"
#include "study/run/lay_beside.h"
#include "study/run/static_run.h"
#include "study/stages/stage_choice.h"

namespace overbend {
namespace {

constexpr const char* kStartedBeside =
    "the equilibrium was found from another one that was given to start from; where something pushes the pipe sideways "
    "there may be several, and the one from nothing may be another";

/// The model at the stage; one with an operation and without a stage is the lay as such, and says so.
Description staged(const Description& whole, const std::string& stage) {
  if (stage.empty()) {
    Description lay = whole;
    lay.findings.push_back(no_stage_finding(whole));
    return lay;
  }
  std::variant<Description, RunEnd> chosen = choose_stage(whole, stage);
  if (const RunEnd* fault = std::get_if<RunEnd>(&chosen)) throw EndedRun(*fault);
  return std::get<Description>(std::move(chosen));
}

}  // namespace

Description chosen_description(const ModelHandle& model, const std::string& stage) {
  const Description& whole = model.description();
  if (stage.empty() && !is_lay_operation(whole.operation.type)) return whole;
  return staged(whole, stage);
}

StaticsHandle::StaticsHandle(std::shared_ptr<ModelHandle> model, const std::string& stage, const StaticsHandle* start)
    : model_(std::move(model)), stage_(stage) {
  const bool plain = stage_.empty() && !is_lay_operation(model_->still().operation.type);
  made_.emplace(build_model(plain ? model_->still() : chosen_description(*model_, stage_)));
  const bool close = made_->description.has_pipe && start != nullptr && start->statics_.solution;
  if (!close || !take(solve_equilibrium(*made_, &*start->statics_.solution))) {
    made_.emplace(build_model(made_->description));  // as it was before the attempt
    take(solve_equilibrium(*made_));
  } else {
    if (pushed_sideways(*made_)) {
      statics_.results->findings.push_back({FindingCode::other_equilibrium_possible, kStartedBeside});
    }
    still_ = start->still();
  }
  if (statics_.failure) throw SolveFault(*statics_.failure);
}

/// False where there is none.
bool StaticsHandle::take(ModelEquilibrium equilibrium) {
  statics_ = {};
  statics_.failure = std::move(equilibrium.failure);
  if (statics_.failure) return false;
  statics_.results = unjudged_statics(*made_, equilibrium);
  statics_.solution = std::move(equilibrium.solution);
  return true;
}

std::optional<StaticSolution> StaticsHandle::still() const {
  const std::lock_guard<std::mutex> hold(mutex_);
  return still_;
}

const StaticRun& StaticsHandle::whole() const {
  const std::lock_guard<std::mutex> hold(mutex_);
  if (told_) return statics_;
  judge_statics(*made_, *statics_.solution, *statics_.results, still_);
  tell_friction(*made_, *statics_.solution, *statics_.results);
  tell_hull(*made_, *statics_.results);
  told_ = true;
  return statics_;
}

Json StaticsHandle::summary(bool all) const {
  if (all) whole();
  const std::lock_guard<std::mutex> hold(mutex_);
  Json summary = static_summary_json(*statics_.results);
  return all ? with_objects(std::move(summary)) : summary;
}

std::shared_ptr<ResultTree> StaticsHandle::tree() const {
  auto tree = std::make_shared<ResultTree>();
  write_static_parts(*tree, *whole().results);
  return tree;
}

void StaticsHandle::save(const std::filesystem::path& folder) const {
  write_static_run(*whole().results, chosen_description(*model_, stage_), folder);
}

}  // namespace overbend
