#include "report/stages/stage_labels.h"

#include <fmt/format.h>

namespace overbend {

std::optional<double> stage_progress(const LayStageDescription& stage) {
  if (stage.cable_out) return stage.cable_out;
  if (stage.pipe_out) return stage.pipe_out;
  return stage.passed ? stage.passed : stage.ahead;
}

std::string progress_name(OperationType type) {
  switch (type) {
    case OperationType::start_up:
    case OperationType::shore_pull:
    case OperationType::hold_back:
      return "Pipe out";
    case OperationType::move:
      return "Barge ahead";
    case OperationType::passage:
      return "Passed";
    case OperationType::ballast:
      return "Along the operation";
    default:
      return "Cable out";
  }
}

std::string operation_title(OperationType type) {
  switch (type) {
    case OperationType::recovery:
      return "Recovery";
    case OperationType::lay_down:
      return "Lay-down";
    case OperationType::start_up:
      return "Start-up";
    case OperationType::move:
      return "Move ahead";
    case OperationType::passage:
      return "Passage of a structure";
    case OperationType::ballast:
      return "Ballast of the stinger";
    case OperationType::lift:
      return "Lift";
    case OperationType::shore_pull:
      return "Pull by a winch at a distance";
    case OperationType::hold_back:
      return "Pull back against a winch at a distance";
    default:
      return "Abandonment";
  }
}

std::string stage_title(const OperationResults& results, std::size_t stage) {
  const std::string number = std::to_string(stage + 1);
  const std::string& name = results.stages[stage].stage.name;
  return name.empty() || name == "stage " + number ? number : fmt::format("{} ({})", number, name);
}

const StaticResults* first_lay(const OperationResults& results) {
  for (const StageResult& stage : results.stages) {
    if (stage.lay) return &*stage.lay;
  }
  return nullptr;
}

}  // namespace overbend
