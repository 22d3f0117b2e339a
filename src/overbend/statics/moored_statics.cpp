#include "statics/moored_statics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/version.h"
#include "moorings/planner.h"
#include "statics/moored_rest.h"
#include "statics/moored_results.h"

namespace overbend {
namespace {

/// Collects states; the first fault stays.
class Stages {
 public:
  Stages(const Model& model, MooringResults& results) : model_(model), results_(results) {}

  std::optional<MooredState> state(const std::string& name, const MooredHull& moored) {
    fault_ = moored.rest.fault ? moored.rest.fault : broken_line(moored);
    if (fault_) {
      where_ = name;
      return std::nullopt;
    }
    MooredState found = moored_state(name, model_, moored.spread, moored.hull, moored.rest, moored.free);
    for (std::string& warning : mooring_warnings(model_, moored.spread, found)) {
      results_.warnings.push_back(std::move(warning));
    }
    return found;
  }
  bool add(const std::string& name, const MooredHull& moored) {
    std::optional<MooredState> found = state(name, moored);
    if (found) results_.stages.push_back(std::move(*found));
    return found.has_value();
  }
  StaticFailure failure() const { return {"no rest of the moored hull", where_, fault_.value_or("")}; }

 private:
  const Model& model_;
  MooringResults& results_;
  MooringFault fault_;
  std::string where_;
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

std::string names_of(const std::vector<VesselLoadDescription>& loads) {
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

/// Ahead along the heading that the hull has, with the pulls it had, changed as little as balance asks.
bool pull_ahead(const Description& d, const MooredHull& start, Stages& stages, MooringResults& results) {
  const OperationDescription& operation = d.operation;
  MooredHull moored = start;
  add_loads(moored, operation.loads);
  find_pose(moored);
  if (!stages.add(names_of(operation.loads), moored)) return false;
  const Eigen::VectorXd wished = pulls_of(moored.spread, moored.rest.lines);
  const HullOffset from = moored.rest.offset;
  for (int move = 1; move <= operation.moves; ++move) {
    HullOffset there = from;
    there[0] += move * operation.distance * std::cos(from[5]);
    there[1] += move * operation.distance * std::sin(from[5]);
    moored.rest = plan_lengths(moored.spread, moored.hull, there, wished, bounds_of(*d.moorings));
    const std::string name = operation.moves == 1 ? "pulled ahead" : fmt::format("pulled ahead {}", move);
    if (!stages.add(name, moored)) return false;
  }
  results.distance = operation.distance * operation.moves;
  results.winches = winch_moves(results.stages.front(), results.stages.back());
  return true;
}

bool run_operation(const Description& d, const MooredHull& start, Stages& stages, MooringResults& results) {
  switch (d.operation.type) {
    case OperationType::moored:
      results.operation = "moored";
      return run_stages(d.operation, start, stages);
    case OperationType::pull_ahead:
      results.operation = "pull_ahead";
      return pull_ahead(d, start, stages, results);
    case OperationType::none:
      break;
  }
  return true;
}

}  // namespace

bool is_moored_hull(const Description& description) {
  return !description.has_pipe && description.lines.empty() && description.moorings &&
         !description.moorings->lines.empty();
}

std::variant<MooringResults, StaticFailure> moored_results(const Model& model, const MooredHull& moored) {
  const Description& d = model.description;
  MooringResults results;
  results.title = d.title;
  results.version = OVERBEND_VERSION;
  results.assumptions = mooring_assumptions(model);
  results.warnings = d.warnings;
  Stages stages(model, results);
  std::optional<MooredState> rest = stages.state("static", moored);
  if (!rest) return stages.failure();
  results.rest = std::move(*rest);
  if (!run_operation(d, moored, stages, results)) return stages.failure();
  return results;
}

std::variant<MooringResults, StaticFailure> solve_moored_hull(const Model& model) {
  std::variant<MooredHull, StaticFailure> made = moored_hull(model);
  if (const StaticFailure* failure = std::get_if<StaticFailure>(&made)) return *failure;
  MooredHull& moored = std::get<MooredHull>(made);
  find_rest_at_start(model.description, moored);
  return moored_results(model, moored);
}

}  // namespace overbend
