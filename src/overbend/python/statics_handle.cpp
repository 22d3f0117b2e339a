#include "python/statics_handle.h"

#include "python/python_errors.h"
#include "resultfiles/hdf5/hdf5_visitors.h"
#include "resultfiles/lines/lines_writer.h"
#include "resultfiles/moored/mooring_hdf5.h"
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
  const bool lay = made_->description.has_pipe;
  const bool close = lay && start != nullptr && start->statics_.solution;
  if (!lay) {
    statics_ = solve_model(*made_);
  } else if (!close || !take_lay(solve_lay(*made_, &*start->statics_.solution))) {
    made_.emplace(build_model(made_->description));  // as it was before the attempt
    take_lay(solve_lay(*made_));
  } else {
    if (pushed_sideways(*made_)) {
      statics_.lay->findings.push_back({FindingCode::other_equilibrium_possible, kStartedBeside});
    }
    still_ = start->still();
  }
  if (statics_.failure) throw SolveFault(*statics_.failure);
}

/// False where there is none.
bool StaticsHandle::take_lay(LayOutcome outcome) {
  statics_ = {};
  statics_.failure = std::move(outcome.failure);
  if (statics_.failure) return false;
  statics_.lay = unjudged_statics(*made_, outcome);
  statics_.solution = std::move(outcome.solution);
  return true;
}

std::optional<StaticSolution> StaticsHandle::still() const {
  const std::lock_guard<std::mutex> hold(mutex_);
  return still_;
}

const ModelStatics& StaticsHandle::whole() const {
  const std::lock_guard<std::mutex> hold(mutex_);
  if (told_) return statics_;
  if (statics_.lay) {
    judge_statics(*made_, *statics_.solution, *statics_.lay, still_);
    tell_friction(*made_, {statics_.solution, {}, {}}, *statics_.lay);
  }
  tell_hull(*made_, statics_);
  told_ = true;
  return statics_;
}

Json StaticsHandle::summary(bool all) const {
  if (all) whole();
  const std::lock_guard<std::mutex> hold(mutex_);
  if (statics_.lay) return static_summary_json(*statics_.lay);
  if (statics_.moorings) return mooring_summary_json(*statics_.moorings);
  return read_json(lines_summary(*statics_.lines));
}

std::shared_ptr<ResultTree> StaticsHandle::tree() const {
  whole();
  auto tree = std::make_shared<ResultTree>();
  const auto moorings = [&](const MooringResults& found) { write_moorings(*tree, found); };
  if (statics_.lines) write_lines_groups(*tree, *statics_.lines);
  if (statics_.moorings) {
    moorings(*statics_.moorings);
    if (statics_.moorings->hull) write_hull(*tree, *statics_.moorings->hull);
  }
  if (statics_.lay) {
    write_lay_group(*tree, "/static", *statics_.lay);
    if (statics_.lay->moorings) moorings(*statics_.lay->moorings);
    if (statics_.lay->hull) write_hull(*tree, *statics_.lay->hull);
  }
  return tree;
}

void StaticsHandle::save(const std::filesystem::path& folder) const {
  write_model_statics(whole(), chosen_description(*model_, stage_), folder);
}

}  // namespace overbend
