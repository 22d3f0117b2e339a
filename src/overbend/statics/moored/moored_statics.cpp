#include "statics/moored/moored_statics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/model_findings.h"
#include "moorings/anchor_plan.h"
#include "moorings/planner.h"
#include "statics/moored/anchor_move.h"
#include "statics/moored/moored_equilibrium.h"
#include "statics/moored/moored_results.h"

namespace overbend {
namespace {

/// Collects states; keeps the first error.
class Stages {
 public:
  Stages(const Model& model, MooredOutcome& outcome)
      : model_(model), results_(outcome.results), findings_(outcome.findings) {}

  std::optional<MooredState> state(const std::string& name, const MooredHull& moored) {
    error_ = moored.rest.error ? moored.rest.error : broken_line(moored);
    if (error_) {
      where_ = name;
      return std::nullopt;
    }
    MooredState found = moored_state(name, model_, moored.spread, moored.hull, moored.rest, moored.free);
    append(findings_, mooring_findings(model_, moored.spread, found));
    return found;
  }
  bool add(const std::string& name, const MooredHull& moored) {
    std::optional<MooredState> found = state(name, moored);
    if (found) results_.stages.push_back(std::move(*found));
    return found.has_value();
  }
  bool fail(StaticFailure failure) {
    failure_ = std::move(failure);
    return false;
  }
  StaticFailure failure() const {
    return failure_.value_or(StaticFailure{"no equilibrium of the moored hull", where_, error_.value_or("")});
  }

 private:
  const Model& model_;
  MooringResults& results_;
  Findings& findings_;
  MooringError error_;
  std::string where_;
  std::optional<StaticFailure> failure_;
};

void add_loads(MooredHull& moored, const std::vector<VesselLoadDescription>& loads) {
  moored.hull.loads.insert(moored.hull.loads.end(), loads.begin(), loads.end());
}

bool run_stages(const OperationDescription& operation, const MooredHull& start, Stages& stages) {
  for (const MooredStageDescription& stage : operation.stages) {
    MooredHull moored = start;
    add_loads(moored, stage.loads);
    for (MooredLine& line : moored.spread.lines) {
      const auto named = std::find(stage.parted.begin(), stage.parted.end(), line.name);
      line.parted = line.parted || named != stage.parted.end();
    }
    find_pose(moored);
    if (!stages.add(stage.name, moored)) return false;
  }
  return true;
}

std::string join_load_names(const std::vector<VesselLoadDescription>& loads) {
  std::string names;
  for (const VesselLoadDescription& load : loads) names += (names.empty() ? "" : ", ") + load.name;
  return names.empty() ? "before" : names;
}

std::vector<WinchMove> winch_moves(const MooredState& before, const MooredState& after) {
  std::vector<WinchMove> moves;
  for (std::size_t i = 0; i < before.moorings.size(); ++i) {
    const MooringLineResult &from = before.moorings[i], &to = after.moorings[i];
    moves.push_back(
        {from.name, from.first_segment_length, to.first_segment_length, from.fairlead_tension, to.fairlead_tension});
  }
  return moves;
}

/// Pulls the hull ahead along the lay route with the smallest change of the lines' forces that gives equilibrium.
bool pull_ahead(const Model& model, const MooredHull& start, const PipeOnHull& pipe, Stages& stages,
                MooringResults& results) {
  const OperationDescription& operation = model.description.operation;
  MooredHull moored = start;
  add_loads(moored, operation.loads);
  find_pose(moored);
  if (!stages.add(join_load_names(operation.loads), moored)) return false;
  PullAheadPath hull(model, moored, pipe);
  const std::vector<double> places = move_positions(move_profile(operation, 0.0));
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (std::optional<StaticFailure> failure = hull.advance_to(places[i])) return stages.fail(std::move(*failure));
    results.steps.push_back(hull.step());
    if (i == 0 || i % kPositionsPerMove != 0) continue;
    const std::string name =
        operation.moves == 1 ? "pulled ahead" : fmt::format("pulled ahead {}", i / kPositionsPerMove);
    if (!stages.add(name, hull.hull())) return false;
  }
  results.distance = operation.distance * operation.moves;
  results.winches = winch_moves(results.stages.front(), results.stages.back());
  return true;
}

bool move_anchor(const Model& model, const MooredHull& start, Stages& stages, MooringResults& results) {
  for (const AnchorStage& stage : anchor_stages(model, start)) {
    if (!stages.add(stage.name, stage.hull)) return false;
  }
  if (!results.stages.empty()) results.winches = winch_moves(results.rest, results.stages.back());
  return true;
}

/// Plans anchor moves with each line at the horizontal force of the initial equilibrium.
bool plan_anchors_due(const Model& model, const MooredHull& start, Stages& stages, MooringResults& results) {
  const OperationDescription& operation = model.description.operation;
  std::vector<LineUsefulRange> useful;
  for (std::size_t i = 0; i < start.spread.lines.size(); ++i) {
    useful.push_back({model.description.moorings->lines[i].useful, start.rest.lines[i].pull});
  }
  const AnchorRoute route{operation.distance * start.hull.axes_WD.col(0), operation.moves};
  const AnchorSchedule schedule = plan_anchors(start.spread, model.nominal_pose.R_WV, useful, route);
  if (schedule.error) return stages.fail({"the anchors cannot be planned", "", *schedule.error});
  for (const AnchorMove& shift : schedule.shifts) {
    results.anchors.push_back(
        {shift.joint, start.spread.lines[shift.line].name, shift.reason, shift.from_W, shift.to_W, shift.length});
  }
  return true;
}

bool run_operation(const Model& model, const MooredHull& start, const PipeOnHull& pipe, Stages& stages,
                   MooringResults& results) {
  const OperationDescription& operation = model.description.operation;
  switch (operation.type) {
    case OperationType::moored:
      results.operation = "moored";
      return run_stages(operation, start, stages);
    case OperationType::pull_ahead:
      results.operation = "pull_ahead";
      return pull_ahead(model, start, pipe, stages, results);
    case OperationType::anchor_move:
      results.operation = "anchor_move";
      return move_anchor(model, start, stages, results);
    case OperationType::anchor_plan:
      results.operation = "anchor_plan";
      return plan_anchors_due(model, start, stages, results);
    default:
      break;
  }
  return true;
}

}  // namespace

std::variant<MooredOutcome, StaticFailure> moored_results(const Model& model, const MooredHull& moored,
                                                          const PipeOnHull& pipe) {
  MooredOutcome outcome{{}, mooring_assumptions(model), model_findings(model)};
  Stages stages(model, outcome);
  std::optional<MooredState> rest = stages.state("static", moored);
  if (!rest) return stages.failure();
  outcome.results.rest = std::move(*rest);
  if (!run_operation(model, moored, pipe, stages, outcome.results)) return stages.failure();
  return outcome;
}

}  // namespace overbend
