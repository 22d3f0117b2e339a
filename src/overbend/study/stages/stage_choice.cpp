#include "study/stages/stage_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "base/text.h"
#include "model/description/operation_names.h"
#include "model/lay_stage.h"
#include "study/run/prepared_case.h"
#include "study/stages/lay_operation.h"

namespace overbend {
namespace {

using Stages = std::vector<LayStageDescription>;

/// Finds a stage by its name, which may look like a number, or by its number from 1.
std::optional<std::size_t> find_stage_index(const Stages& stages, const std::string& wanted) {
  const auto named =
      std::find_if(stages.begin(), stages.end(), [&](const auto& stage) { return stage.name == wanted; });
  if (named != stages.end()) return static_cast<std::size_t>(named - stages.begin());
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), number);
  const bool is_number = error == std::errc() && end == wanted.data() + wanted.size();
  if (!is_number || number < 1 || number > stages.size()) return std::nullopt;
  return number - 1;
}

RunResult no_such_stage(const Stages& stages, const std::string& wanted) {
  const std::string shown = for_display(wanted);
  if (stages.empty()) {
    return {RunStatus::wrong_input,
            fmt::format("there is no stage '{}': the model has no operation on the line", shown)};
  }
  const std::string which = stages.size() == 1 ? fmt::format("the only one is 1, '{}'", stages.front().name)
                                               : fmt::format("give a number from 1 ('{}') to {} ('{}'), or a name",
                                                             stages.front().name, stages.size(), stages.back().name);
  return {RunStatus::wrong_input, fmt::format("there is no stage '{}': {}", shown, which)};
}

/// True if make_stage_description() has all that it needs: a tension, or an anchor whose position determines it.
bool is_complete(const Description& d, const LayStageDescription& stage) {
  return stage.tension || (d.operation.lay.anchor && d.operation.lay.anchor->distance);
}

/// Returns the stage with its tension, found by solving all stages before it.
std::variant<LayStageDescription, RunResult> solved_stage(const Description& d, std::size_t index) {
  std::size_t done = 0;
  const auto until = [&](const StageResult&, std::size_t) { return ++done <= index; };
  const OperationResults results = solve_operation(d, until);
  const StageResult& stage = results.stages.at(index);
  if (stage.lay) return stage.stage;
  const StageFailure& failure = *stage.failure;
  return failure_result({failure.what, failure.where, failure.why}, d);
}

bool yields(const Description& d) {
  const auto beyond_linear = [](const SectionDescription& s) { return s.steel.material.law != MaterialLaw::linear; };
  return beyond_linear(d.pipe.section) ||
         std::any_of(d.pipe.segments.begin(), d.pipe.segments.end(),
                     [&](const SegmentDescription& segment) { return beyond_linear(segment.section); });
}

}  // namespace

std::variant<Description, RunResult> choose_stage(const Description& description, const std::string& wanted) {
  const bool lift = description.operation.type == OperationType::lift;
  const Stages stages = lift || is_lay_operation(description.operation.type) ? lay_stages(description) : Stages{};
  const std::optional<std::size_t> index = find_stage_index(stages, wanted);
  if (!index) return no_such_stage(stages, wanted);
  LayStageDescription stage = stages[*index];
  if (!lift && !is_complete(description, stage)) {
    std::variant<LayStageDescription, RunResult> solved = solved_stage(description, *index);
    if (const RunResult* error = std::get_if<RunResult>(&solved)) return *error;
    stage = std::get<LayStageDescription>(solved);
  }
  Description chosen = make_stage_description(description, stage);
  chosen.title = fmt::format("{}, {}", description.title, stage.name);
  if (yields(chosen)) {
    chosen.findings.push_back({FindingCode::stage_without_history,
                               "operation: the stage is computed alone, without plastic strain from earlier stages"});
  }
  return chosen;
}

Finding no_stage_finding(const Description& description, bool choosable) {
  return {FindingCode::no_stage_chosen,
          fmt::format("operation: no stage of the operation {} was chosen; the normal lay is analysed{}",
                      operation_name(description.operation.type), choosable ? " (choose with --stage)" : "")};
}

}  // namespace overbend
