/// Selects the static analysis of a model, and solves lines without a lay.
#include <algorithm>
#include <stdexcept>

#include "base/ranges.h"
#include "model/model_findings.h"
#include "model/vessel/mooring_queries.h"
#include "statics/moored/moored_lay.h"
#include "statics/recovery/body_recovery.h"
#include "statics/recovery/lift_findings.h"
#include "statics/recovery/lift_recovery.h"
#include "statics/recovery/lifted_line.h"
#include "statics/recovery/lines_recovery.h"
#include "statics/solver/floating_hull.h"
#include "statics/solver/line_reach.h"
#include "statics/solver/lines_setup.h"

namespace overbend {
namespace {

constexpr double kLongTime = 1e6;  ///< Pseudo time step without inertia: friction is as mobilised so far [s].

StaticFailure unbalanced(const Model& model, const LinesEquilibriumReport& rest) {
  const auto worst = ranges::find_if(rest.lines, [](const auto& line) { return !line.converged(); });
  const std::string name = model.description.lines[static_cast<std::size_t>(worst - rest.lines.begin())].name;
  return {"no equilibrium was found", "line \"" + name + "\"",
          "its forces do not balance; a longer line or a finer `element` may help"};
}

/// Brings the lines to their nominal position or, at a stage of a lift, through the previous stages as far as these
/// have a solution.
std::optional<StaticFailure> bring_to_stage(LinkedLines& linked, const Description& description) {
  if (!description.stage) return linked.move_to(nominal_position(description));
  LiftPosition last = nominal_position(description);
  std::optional<StaticFailure> failure;
  for (const LayStageDescription& stage : description.operation.lay.stages) {
    failure = linked.move_to(stage_position(description, stage, last));
    if (!failure) last = linked.position();
  }
  return failure;
}

/// Solves lines attached to each other together.
ModelEquilibrium solve_linked_lines(const Model& model) {
  ModelEquilibrium found;
  LinkedLines linked(model);
  found.failure = bring_to_stage(linked, model.description);
  if (found.failure) return found;
  found.assumptions = lift_assumptions(model);
  found.findings = model_findings(model);
  found.lines = recover_linked_lines(model, linked);
  found.lift = recover_lift(model, linked, nullptr);
  warn_of_lift(model, *found.lift, found.findings);
  warn_of_wires(model, found.lines, found.findings);
  found.bodies = recover_bodies(model, linked.assembly(), linked.state());
  found.solution.emplace();
  found.solution->pose = linked.assembly().surroundings().bodies[kVessel].pose;
  found.solution->lines = std::make_shared<StaticLines>(linked.make_static_lines());
  return found;
}

/// Releases the vessel of lines in equilibrium, if it floats freely.
std::optional<StaticFailure> float_on_lines(const Model& model, StaticLines& lines, StaticSolution& solution) {
  solution.pose = model.mean_pose;
  if (!lines.setup.hull) return std::nullopt;
  HeldVessel held = release_vessel(model, lines.setup, lines.state);
  if (held.failure) return std::move(held.failure);
  solution.station_stiffness = held.stiffness;
  return std::nullopt;
}

/// Leaves the assembly evaluated at a coupled equilibrium of lines and bodies.
void evaluate_together(Assembly& assembly, SystemState& state) {
  const SystemState laid = state;
  Equilibrium equilibrium(assembly, {LayHistory::monotonic, &laid, kLongTime});
  equilibrium.evaluate(state, false);
}

ModelEquilibrium solve_lines_alone(const Model& model) {
  ModelEquilibrium found;
  auto lines = std::make_shared<StaticLines>(StaticLines{lines_setup(model), {}, {}});
  float_vessel(model, lines->setup);
  lines->state = make_initial_state(lines->setup, 0.0);
  Assembly assembly(lines->setup.system);
  lines->rest = solve_lines_one_by_one(assembly, lines->state);
  if (!lines->rest.converged()) {
    found.failure = unbalanced(model, lines->rest);
    return found;
  }
  found.solution.emplace();
  found.failure = float_on_lines(model, *lines, *found.solution);
  if (found.failure) {
    found.solution.reset();
    return found;
  }
  if (lines->setup.hull) evaluate_together(assembly, lines->state);
  found.assumptions = line_assumptions(model);
  found.findings = model_findings(model);
  found.lines = recover_lines(model, assembly, *lines, found.findings);
  if (std::vector<LiftedLine> pipe = recover_pipe_lines({model, lines->setup, assembly, lines->state}); !pipe.empty()) {
    found.lift.emplace().lines = std::move(pipe);
  }
  found.bodies = recover_bodies(model, assembly, lines->state);
  found.solution->pose = assembly.surroundings().bodies[kVessel].pose;
  found.solution->lines = std::move(lines);
  return found;
}

}  // namespace

std::optional<StaticFailure> unsupported_lines(const Description& description) {
  if (has_mooring_lines(description)) {
    return StaticFailure{"lines on a vessel with mooring lines are not supported", "",
                         "give all of them under lines, or use separate models", true, "lines"};
  }
  const std::optional<CoupledHullDescription>& coupled = description.vessel.coupled;
  if (!coupled || coupled->data) return std::nullopt;
  return StaticFailure{"the free-floating hull has no hydrodynamic coefficients", "",
                       "the files " + coupled->hydrodynamics + " could not be read", true, "vessel.motion.coupled"};
}

ModelEquilibrium solve_lines(const Model& model) {
  ModelEquilibrium found;
  found.failure = unsupported_lines(model.description);
  if (!found.failure) found.failure = reach_failure(model, nominal_position(model.description));
  if (found.failure) return found;
  try {
    return has_linked_lines(model.description) ? solve_linked_lines(model) : solve_lines_alone(model);
  } catch (const std::invalid_argument& error) {
    found.failure = StaticFailure{"the free-floating hull is invalid", "", error.what(), true, "vessel"};
    return found;
  }
}

ModelEquilibrium solve_equilibrium(Model& model, const StaticSolution* start, const LoadHistory& past) {
  const Description& d = model.description;
  if (d.has_pipe) return solve_lay(model, start, past);
  if (!d.lines.empty()) {
    model.mean_pose = model.nominal_pose;
    ModelEquilibrium lines = solve_lines(model);
    if (lines.solution) model.mean_pose = lines.solution->pose;
    return lines;
  }
  if (finds_vessel_position(d)) return solve_moored_hull(model);
  return solve_lay(model, start, past);  // rejects an empty model
}

}  // namespace overbend
