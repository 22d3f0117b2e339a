#include "study/stages/lift.h"

#include <algorithm>
#include <chrono>
#include <limits>

#include "base/version.h"
#include "checks/run_checks.h"
#include "model/bodies.h"
#include "model/model_findings.h"
#include "statics/moored/moored_lay.h"
#include "statics/recovery/body_recovery.h"
#include "statics/recovery/lift_findings.h"
#include "statics/recovery/lift_recovery.h"
#include "statics/recovery/lines_recovery.h"
#include "statics/solver/line_reach.h"

namespace overbend {
namespace {

std::string stage_name(const std::vector<LayStageDescription>& stages, std::size_t i) {
  return stages[i].name.empty() ? "stage " + std::to_string(i + 1) : stages[i].name;
}

/// Returns the next weld to be made.
const JoinDescription* next_join(const std::vector<LayStageDescription>& stages, std::size_t stage) {
  for (std::size_t i = stage; i < stages.size(); ++i) {
    if (stages[i].join) return &*stages[i].join;
  }
  return nullptr;
}

/// Results of a stage, in the form of the static results of a model of lines only.
StaticResults recover_stage_results(const Model& model, const LinkedLines& lines, const JoinDescription* join) {
  StaticResults results;
  results.title = model.description.title;
  results.version = kVersion;
  results.findings = model_findings(model);
  results.assumptions = lift_assumptions(model);
  results.lines = recover_linked_lines(model, lines);
  results.lift = recover_lift(model, lines, join);
  results.bodies = recover_bodies(model, lines.assembly(), lines.state());
  warn_of_lift(model, *results.lift, results.findings);
  warn_of_wires(model, results.lines, results.findings);
  fill_checks(model, results);
  accept(results.findings, model.description.checks.accepted_findings);
  return results;
}

StageFailure make_stage_failure(const StaticFailure& failure) {
  return {failure.what, failure.where, failure.why, std::nullopt};
}

}  // namespace

std::optional<StaticFailure> find_unreachable_stage(const Description& description) {
  const Model model = build_model(description);
  LiftPosition position = nominal_position(description);
  const std::vector<LayStageDescription>& stages = description.operation.lay.stages;
  for (std::size_t i = 0; i < stages.size(); ++i) {
    position = stage_position(description, stages[i], std::move(position));
    if (std::optional<StaticFailure> failure = reach_failure(model, position)) {
      failure->where = "stage \"" + stage_name(stages, i) + "\"";
      failure->key = "operation.stages[" + std::to_string(i) + "]";
      return failure;
    }
    for (std::size_t line = 0; line < position.lengths.size(); ++line) {  // the tension determines the length
      if (position.tensions[line]) position.lengths[line] = std::numeric_limits<double>::infinity();
      position.tensions[line].reset();
    }
  }
  return std::nullopt;
}

Lift::Lift(const Description& description)
    : model_(std::make_shared<const Model>(build_model(description))),
      lines_(*model_),
      last_(nominal_position(description)) {}  // stages may name nothing until the first one is solved

StageResult Lift::next(const std::vector<LayStageDescription>& stages) {
  StageResult result;
  result.stage = stages.at(passed_++);
  if (result.stage.name.empty()) result.stage.name = "stage " + std::to_string(passed_);
  const LiftPosition target = stage_position(model_->description, result.stage, last_);
  if (const std::optional<StaticFailure> failure = lines_.move_to(target)) {
    result.failure = make_stage_failure(*failure);
  } else {
    result.lay = recover_stage_results(*model_, lines_, next_join(stages, passed_));
    last_ = lines_.position();
  }
  return result;
}

OperationResults solve_lift(const Description& description,
                            const std::function<bool(const StageResult&, std::size_t of)>& on_stage) {
  const auto begin = std::chrono::steady_clock::now();
  OperationResults results;
  results.title = description.title;
  results.version = kVersion;
  results.type = description.operation.type;
  const std::vector<LayStageDescription>& stages = description.operation.lay.stages;
  if (const std::optional<StaticFailure> unsupported = unsupported_lines(description)) {
    for (const LayStageDescription& stage : stages) {
      StageResult& failed = results.stages.emplace_back();
      failed.stage = stage;
      failed.failure = make_stage_failure(*unsupported);
    }
    return results;
  }
  Lift lift(description);
  for (std::size_t i = 0; i < stages.size(); ++i) {
    results.stages.push_back(lift.next(stages));
    if (on_stage && !on_stage(results.stages.back(), stages.size())) break;
  }
  results.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return results;
}

}  // namespace overbend
