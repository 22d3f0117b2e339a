#include "study/stages/lay_operation.h"

#include <chrono>
#include <cmath>

#include "base/version.h"
#include "model/lay_stage.h"
#include "report/stages/operation_report.h"
#include "resultfiles/stages/operation_writer.h"
#include "runstore/staged_folder.h"
#include "statics/solver/unsupported_statics.h"
#include "study/stages/lift.h"
#include "study/stages/stage_tension.h"

namespace overbend {
namespace {

/// Horizontal distance per length of pipe on the seabed [-]: the cosine of the slope, or the mean over the laid part of
/// an uneven seabed.
double level_fraction(const StaticResults& r) {
  double along = 0.0, level = 0.0;
  for (std::size_t i = 1; i < r.stations.size() && r.stations[i].region == Region::seabed; ++i) {
    const Vec3 step = r.stations[i].p_W - r.stations[i - 1].p_W;
    along += step.norm();
    level += step.head<2>().norm();
  }
  return along > 0.0 ? level / along : 1.0;
}

/// Horizontal distance from the stern shoe to a point of the line that stays fixed on the seabed from stage to stage,
/// up to a constant [m].
double distance_to_laid(const StageResult& stage) {
  const StaticResults& r = *stage.lay;
  if (r.far_anchor) return r.far_anchor->distance;
  const LayStageDescription& planned = stage.stage;
  const double advanced = planned.cable_out.value_or(planned.ahead.value_or(planned.passed.value_or(0.0)));
  return r.lay_back - level_fraction(r) * (r.length_top_to_touchdown - advanced);
}

/// Relative to the first solved stage. While ballast is changed or the pipe is dragged along the seabed the barge
/// stays, and the tensioner pays out or hauls in.
void place_barge(std::vector<StageResult>& stages) {
  std::optional<double> first;
  for (StageResult& stage : stages) {
    if (!stage.lay || stage.lay->dragging || stage.stage.tank_weight || stage.stage.tank_ballast) continue;
    if (!first) first = distance_to_laid(stage);
    stage.barge_ahead = distance_to_laid(stage) - *first;
  }
}

void copy_head(OperationResults& results, const Description& description) {
  results.title = description.title;
  results.version = kVersion;
  results.type = description.operation.type;
}

}  // namespace

OperationResults solve_operation(const Description& description,
                                 const std::function<bool(const StageResult&, std::size_t of)>& on_stage) {
  if (description.operation.type == OperationType::lift) return solve_lift(description, on_stage);
  const auto begin = std::chrono::steady_clock::now();
  OperationResults results;
  copy_head(results, description);
  const std::vector<LayStageDescription> stages = lay_stages(description);
  StageSolver solver(description);
  const std::vector<PlannedStage> planned = solver.plan(stages);
  for (const PlannedStage& stage : planned) {
    results.stages.push_back(solver.solve(stage));
    if (on_stage && !on_stage(results.stages.back(), planned.size())) break;
  }
  place_barge(results.stages);
  results.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return results;
}

std::optional<StaticFailure> unsupported_in_operation(const Description& description) {
  if (description.operation.type == OperationType::lift) return find_unreachable_stage(description);
  for (const LayStageDescription& stage : lay_stages(description)) {
    if (auto unsupported = unsupported_in_statics(make_stage_description(description, stage))) return unsupported;
  }
  return std::nullopt;
}

void write_operation_run(const OperationResults& results, const Description& description,
                         const std::filesystem::path& folder) {
  StagedFolder staged(folder);
  write_operation_files(results, description, staged.path());
  write_operation_report(results, description.source_text, staged.path() / "report.html");
  staged.commit("summary.json");
}

}  // namespace overbend
