/// Which statics a model has, and those of lines by themselves.
#include <algorithm>

#include "model/model_findings.h"
#include "model/vessel/station.h"
#include "statics/moored/moored_lay.h"
#include "statics/recovery/lift_findings.h"
#include "statics/recovery/lift_recovery.h"
#include "statics/recovery/lifted_line.h"
#include "statics/recovery/lines_recovery.h"
#include "statics/solver/line_reach.h"
#include "statics/solver/lines_setup.h"

namespace overbend {
namespace {

/// A vessel that floats free moves by what the lines do to it, which is not computed here.
std::optional<StaticFailure> lines_obstacle(const Description& description) {
  if (has_mooring_lines(description)) {
    return StaticFailure{"lines on a vessel on mooring lines cannot be solved yet", "",
                         "give lines and moorings in models of their own", true, "lines"};
  }
  const VesselDescription& vessel = description.vessel;
  if (!vessel.coupled && !vessel.hydrostatics && vessel.motion != VesselMotion::coupled) return std::nullopt;
  return StaticFailure{"lines on a hull that floats free cannot be solved by themselves yet", "",
                       "give them under moorings, or another vessel.motion than coupled without vessel.hydrostatics",
                       true};
}

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
  found.solution.emplace();
  found.solution->pose = linked.vessel_pose();
  found.solution->lines = std::make_shared<LinesAtRest>(linked.at_rest());
  return found;
}

}  // namespace

ModelEquilibrium solve_lines(const Model& model) {
  ModelEquilibrium found;
  found.failure = lines_obstacle(model.description);
  if (!found.failure) found.failure = reach_failure(model, drawn_position(model.description));
  if (found.failure) return found;
  if (has_linked_lines(model.description)) return solve_linked_lines(model);
  auto lines = std::make_shared<LinesAtRest>(LinesAtRest{lines_setup(model), {}, {}});
  lines->state = start_of(lines->setup, 0.0);
  Assembly assembly(lines->setup.system);
  lines->rest = rest_lines(assembly, lines->state);
  if (!lines->rest.converged()) {
    found.failure = unbalanced(model, lines->rest);
    return found;
  }
  found.assumptions = line_assumptions(model);
  found.findings = model_findings(model);
  found.lines = recover_lines(model, assembly, *lines, found.findings);
  if (std::vector<LiftedLine> pipe = recover_pipe_lines({model, lines->setup, assembly, lines->state}); !pipe.empty()) {
    found.lift.emplace().lines = std::move(pipe);
  }
  found.solution.emplace();
  found.solution->pose = model.mean_pose;
  found.solution->lines = std::move(lines);
  return found;
}

ModelEquilibrium solve_equilibrium(Model& model, const StaticSolution* start, const LinePast& past) {
  const Description& d = model.description;
  if (d.has_pipe) return solve_lay(model, start, past);
  if (!d.lines.empty()) {
    ModelEquilibrium found = solve_lines(model);
    if (found.solution) model.mean_pose = found.solution->pose;
    return found;
  }
  if (has_station(d)) return solve_moored_hull(model);
  return solve_lay(model, start, past);  // refuses a model without anything
}

}  // namespace overbend
