/// Which statics a model has, and those of lines by themselves.
#include <algorithm>
#include <stdexcept>

#include "model/model_findings.h"
#include "model/vessel/station.h"
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

constexpr double kLongTime = 1e6;  ///< Without inertia: friction is what it has become [s].

StaticFailure unbalanced(const Model& model, const LinesRest& rest) {
  const auto worst = std::ranges::find_if(rest.lines, [](const auto& line) { return !line.converged(); });
  const std::string name = model.description.lines[static_cast<std::size_t>(worst - rest.lines.begin())].name;
  return {"no equilibrium was found", "line \"" + name + "\"",
          "its forces do not balance; a longer line or a finer `element` may help"};
}

/// As they are drawn; at a stage of a lift by way of those before it, as far as these can be.
std::optional<StaticFailure> bring_to_stage(LinkedLines& linked, const Description& description) {
  if (!description.stage) return linked.bring_to(drawn_position(description));
  LiftPosition last = drawn_position(description);
  std::optional<StaticFailure> failure;
  for (const LayStageDescription& stage : description.operation.lay.stages) {
    failure = linked.bring_to(stage_position(description, stage, last));
    if (!failure) last = linked.position();
  }
  return failure;
}

/// Lines that hold each other rest together.
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
  found.solution->lines = std::make_shared<LinesAtRest>(linked.at_rest());
  return found;
}

/// Of lines at rest on a vessel that is held: lets it go, where it floats.
std::optional<StaticFailure> float_on_lines(const Model& model, LinesAtRest& lines, StaticSolution& solution) {
  solution.pose = model.mean_pose;
  if (!lines.setup.hull) return std::nullopt;
  HeldVessel held = let_vessel_float(model, lines.setup, lines.state);
  if (held.failure) return std::move(held.failure);
  solution.station_stiffness = held.stiffness;
  return std::nullopt;
}

/// Leaves an assembly evaluated at a state of lines and bodies that rest together.
void evaluate_together(Assembly& assembly, SystemState& state) {
  const SystemState laid = state;
  Equilibrium equilibrium(assembly, {LayHistory::monotonic, &laid, kLongTime});
  equilibrium.evaluate(state, false);
}

ModelEquilibrium solve_lines_alone(const Model& model) {
  ModelEquilibrium found;
  auto lines = std::make_shared<LinesAtRest>(LinesAtRest{lines_setup(model), {}, {}});
  float_vessel(model, lines->setup);
  lines->state = start_of(lines->setup, 0.0);
  Assembly assembly(lines->setup.system);
  lines->rest = rest_lines(assembly, lines->state);
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

std::optional<StaticFailure> lines_obstacle(const Description& description) {
  if (has_mooring_lines(description)) {
    return StaticFailure{"lines on a vessel on mooring lines cannot be solved yet", "",
                         "give all of them under lines, or in models of their own", true, "lines"};
  }
  const std::optional<CoupledHullDescription>& coupled = description.vessel.coupled;
  if (!coupled || coupled->data) return std::nullopt;
  return StaticFailure{"the hull that floats free has no hydrodynamic coefficients", "",
                       "the files " + coupled->hydrodynamics + " could not be read", true, "vessel.motion.coupled"};
}

ModelEquilibrium solve_lines(const Model& model) {
  ModelEquilibrium found;
  found.failure = lines_obstacle(model.description);
  if (!found.failure) found.failure = reach_failure(model, drawn_position(model.description));
  if (found.failure) return found;
  try {
    return has_linked_lines(model.description) ? solve_linked_lines(model) : solve_lines_alone(model);
  } catch (const std::invalid_argument& fault) {
    found.failure = StaticFailure{"the hull that floats free cannot be made", "", fault.what(), true, "vessel"};
    return found;
  }
}

ModelEquilibrium solve_equilibrium(Model& model, const StaticSolution* start, const LinePast& past) {
  const Description& d = model.description;
  if (d.has_pipe) return solve_lay(model, start, past);
  if (!d.lines.empty()) {
    model.mean_pose = model.drawn_pose;
    ModelEquilibrium lines = solve_lines(model);
    if (lines.solution) model.mean_pose = lines.solution->pose;
    return lines;
  }
  if (has_station(d)) return solve_moored_hull(model);
  return solve_lay(model, start, past);  // refuses a model without anything
}

}  // namespace overbend
