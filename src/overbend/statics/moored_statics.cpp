#include "statics/moored_statics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/version.h"
#include "moorings/hull_at_rest.h"
#include "moorings/planner.h"
#include "statics/moored_results.h"

namespace overbend {
namespace {

/// Rounds of ballast and lengths, each of which hardly changes the other.
constexpr int kTrimRounds = 4;

/// The hull on its lines at one stage.
struct Moored {
  MooringSpread spread;
  HullAtRest hull;
  RestOutcome rest;
  bool free = true;
};

TensionBounds bounds_of(const MooringsDescription& moorings) {
  TensionBounds bounds;
  bounds.least = moorings.least_tension.value_or(bounds.least);
  bounds.most = moorings.working_load.value_or(bounds.most);
  return bounds;
}

/// A held hull: the lines alone.
void solve_lines(Moored& moored) {
  moored.rest.forces = hull_forces(moored.spread, moored.hull, moored.rest.offset, moored.rest.lines);
  moored.rest.fault = moored.rest.forces.fault;
}

void solve_pose(Moored& moored) {
  if (moored.free) {
    moored.rest = find_rest(moored.spread, moored.hull, moored.rest.offset);
  } else {
    solve_lines(moored);
  }
}

/// Lengths that hold the hull as drawn, with the least change of the pulls that the lines have as drawn.
void solve_lengths(Moored& moored, const TensionBounds& bounds) {
  solve_lines(moored);
  if (moored.rest.fault || !moored.free) return;
  const Eigen::VectorXd wished = pulls_of(moored.spread, moored.rest.lines);
  moored.rest = plan_lengths(moored.spread, moored.hull, HullOffset::Zero(), wished, bounds);
}

/// The state that the analysis starts with: lengths or pose, and ballast.
void solve_start(const Description& d, Moored& moored) {
  const bool lengths = d.moorings->find == FindMooring::lengths;
  const bool trim = moored.free && d.vessel.coupled && d.vessel.coupled->ballast == Ballast::trim;
  for (int round = 0; round < (trim ? kTrimRounds : 1) && !moored.rest.fault; ++round) {
    if (trim) moored.rest = trim_ballast(moored.spread, moored.hull, HullOffset::Zero());
    if (moored.rest.fault) return;
    if (lengths) {
      solve_lengths(moored, bounds_of(*d.moorings));
    } else {
      solve_pose(moored);
    }
  }
}

/// A line that would have to break to reach.
MooringFault broken_line(const Moored& moored) {
  const HullPlace place = place_of(moored.hull, moored.rest.offset);
  for (std::size_t i = 0; i < moored.spread.lines.size(); ++i) {
    const MooredLine& line = moored.spread.lines[i];
    const Vec3 fairlead = place.p_W + place.R_WV * line.fairlead_V;
    const bool stretched = (line.anchor_W - fairlead).norm() > line.line.length();
    if (!line.parted && stretched && line.breaking_load && moored.rest.lines[i].tension() > *line.breaking_load) {
      return line_fault(moored.spread, line, fairlead, CatenaryFault::too_short);
    }
  }
  return std::nullopt;
}

/// Collects states; the first fault stays.
class Stages {
 public:
  Stages(const Model& model, MooringResults& results) : model_(model), results_(results) {}

  std::optional<MooredState> state(const std::string& name, const Moored& moored) {
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
  bool add(const std::string& name, const Moored& moored) {
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

void add_loads(Moored& moored, const std::vector<VesselLoadDescription>& loads) {
  moored.hull.loads.insert(moored.hull.loads.end(), loads.begin(), loads.end());
}

bool run_stages(const OperationDescription& operation, const Moored& start, Stages& stages) {
  for (const MooredStageDescription& stage : operation.stages) {
    Moored moored = start;
    add_loads(moored, stage.loads);
    for (MooredLine& line : moored.spread.lines) {
      const auto named = std::find(stage.parted.begin(), stage.parted.end(), line.name);
      line.parted = line.parted || named != stage.parted.end();
    }
    solve_pose(moored);
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
bool pull_ahead(const Description& d, const Moored& start, Stages& stages, MooringResults& results) {
  const OperationDescription& operation = d.operation;
  Moored moored = start;
  add_loads(moored, operation.loads);
  solve_pose(moored);
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

bool run_operation(const Description& d, const Moored& start, Stages& stages, MooringResults& results) {
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

std::variant<MooringResults, StaticFailure> solve_moored_hull(const Model& model) {
  const Description& d = model.description;
  MooringResults results;
  results.title = d.title;
  results.version = OVERBEND_VERSION;
  results.assumptions = mooring_assumptions(model);
  results.warnings = d.warnings;
  Moored moored;
  moored.hull = hull_at_rest(d);
  moored.free = hull_is_free(d);
  SpreadOutcome outcome = build_spread(*d.moorings, model.seabed.surface, model.mean_pose.R_WV);
  if (outcome.fault) return StaticFailure{"the mooring lines cannot be as given", "", *outcome.fault};
  if (d.operation.type == OperationType::pull_ahead && !moored.free) {
    return StaticFailure{"a held hull cannot be pulled ahead", "operation.type",
                         "give vessel.hydrostatics or vessel.motion.coupled, or leave out the operation", true};
  }
  moored.spread = std::move(outcome.spread);
  Stages stages(model, results);
  solve_start(d, moored);
  std::optional<MooredState> rest = stages.state("static", moored);
  if (!rest) return stages.failure();
  results.rest = std::move(*rest);
  if (!run_operation(d, moored, stages, results)) return stages.failure();
  return results;
}

}  // namespace overbend
