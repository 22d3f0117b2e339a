#include "study/stages/lift.h"

#include <algorithm>
#include <chrono>
#include <limits>

#include "base/version.h"
#include "checks/run_checks.h"
#include "model/model_findings.h"
#include "statics/recovery/lift_findings.h"
#include "statics/recovery/lift_recovery.h"
#include "statics/recovery/lines_recovery.h"
#include "statics/solver/line_reach.h"

namespace overbend {
namespace {

std::string stage_name(const std::vector<LayStageDescription>& stages, std::size_t i) {
  return stages[i].name.empty() ? "stage " + std::to_string(i + 1) : stages[i].name;
}

/// The first weld that is still to be made.
const JoinDescription* next_join(const Description& description, std::size_t stage) {
  const std::vector<LayStageDescription>& stages = description.operation.lay.stages;
  for (std::size_t i = stage; i < stages.size(); ++i) {
    if (stages[i].join) return &*stages[i].join;
  }
  return nullptr;
}

/// A stage is a model at rest, told in the same words as lines by themselves.
StaticResults results_of(const Model& model, const LinkedLines& lines, const JoinDescription* join) {
  StaticResults results;
  results.title = model.description.title;
  results.version = kVersion;
  results.findings = model_findings(model);
  results.assumptions = lift_assumptions(model);
  results.lines = recover_linked_lines(model, lines);
  results.lift = recover_lift(model, lines, join);
  warn_of_lift(model, *results.lift, results.findings);
  fill_checks(model, results);
  accept(results.findings, model.description.checks.accepted_findings);
  return results;
}

StageFailure failure_of(const StaticFailure& failure) {
  return {failure.what, failure.where, failure.why, std::nullopt};
}

}  // namespace

std::optional<StaticFailure> lift_obstacle(const Description& description) {
  const Model model = build_model(description);
  LiftPosition position = drawn_position(description);
  const std::vector<LayStageDescription>& stages = description.operation.lay.stages;
  for (std::size_t i = 0; i < stages.size(); ++i) {
    position = stage_position(description, stages[i], std::move(position));
    if (std::optional<StaticFailure> failure = reach_failure(model, position)) {
      failure->where = "stage \"" + stage_name(stages, i) + "\"";
      failure->key = "operation.stages[" + std::to_string(i) + "]";
      return failure;
    }
    for (std::size_t line = 0; line < position.lengths.size(); ++line) {  // as long as the tension makes it
      if (position.tensions[line]) position.lengths[line] = std::numeric_limits<double>::infinity();
      position.tensions[line].reset();
    }
  }
  return std::nullopt;
}

OperationResults solve_lift(const Description& description,
                            const std::function<bool(const StageResult&, std::size_t of)>& told) {
  const auto begin = std::chrono::steady_clock::now();
  OperationResults results;
  results.title = description.title;
  results.version = kVersion;
  results.type = description.operation.type;
  const Model model = build_model(description);
  LinkedLines lines(model);
  const std::vector<LayStageDescription>& stages = description.operation.lay.stages;
  LiftPosition last = drawn_position(description);  // of which the stages up to the first that stands may name nothing
  for (std::size_t i = 0; i < stages.size(); ++i) {
    StageResult& stage = results.stages.emplace_back();
    stage.stage = stages[i];
    stage.stage.name = stage_name(stages, i);
    const LiftPosition target = stage_position(description, stages[i], last);
    if (const std::optional<StaticFailure> failure = lines.bring_to(target)) {
      stage.failure = failure_of(*failure);
    } else {
      stage.lay = results_of(model, lines, next_join(description, i + 1));
      last = lines.position();
    }
    if (told && !told(stage, stages.size())) break;
  }
  results.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return results;
}

}  // namespace overbend
