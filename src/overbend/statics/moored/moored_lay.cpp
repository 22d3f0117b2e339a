#include "statics/moored/moored_lay.h"

#include <algorithm>
#include <cmath>

#include "model/vessel/mooring_queries.h"
#include "statics/moored/hull_statics.h"
#include "statics/moored/moored_statics.h"
#include "statics/moored/pipe_load.h"
#include "statics/recovery/recovery.h"
#include "statics/stinger/stinger_equilibrium.h"

namespace overbend {
namespace {

constexpr int kMaxIterations = 40;
constexpr int kMaxTensionIterations = 10;  ///< Maximum number of iterations over the tension for yielding steel, if the
                                           ///< tension is a result.
constexpr double kConvergedMove = 1e-7;    ///< Displacement of the hull's ends between iterations at convergence [m].

HullPlace make_hull_place(const VesselPose& pose) {
  return {pose.p_WV, pose.R_WV};
}

ModelEquilibrium fail(StaticFailure failure) {
  ModelEquilibrium none;
  none.failure = std::move(failure);
  return none;
}

double surge_period(const MooredState& rest) {
  for (const PeriodResult& period : rest.vessel.natural_periods) {
    if (period.mode == "surge") return period.period;
  }
  return 0.0;
}

/// `start`: solution of the pipe, or none; the lines of the hull are added.
ModelEquilibrium make_equilibrium(const Model& model, StaticSolution start, const MooredHull& moored,
                                  const PipeOnHull& pipe) {
  std::variant<MooredOutcome, StaticFailure> outcome = moored_results(model, moored, pipe);
  if (const StaticFailure* failure = std::get_if<StaticFailure>(&outcome)) {
    return fail(*failure);
  }
  MooredOutcome& found = std::get<MooredOutcome>(outcome);
  const MooringResults& results = found.results;
  start.moorings = moored.spread;
  if (const auto& hull = model.description.vessel.coupled) {
    start.station_stiffness = station_stiffness(&results.rest, hull->centre_of_gravity);
  }
  if (!results.steps.empty()) {
    start.winches = winch_plan(model.description.operation, results.steps, surge_period(results.rest));
  }
  ModelEquilibrium equilibrium;
  equilibrium.solution = std::move(start);
  equilibrium.moorings = std::move(found.results);
  equilibrium.assumptions = std::move(found.assumptions);
  equilibrium.findings = std::move(found.findings);
  return equilibrium;
}

StaticFailure no_equilibrium(const MooredHull& moored) {
  return {"no equilibrium of the moored hull", "static", *moored.rest.error};
}

}  // namespace

bool is_moored_lay(const Description& description) {
  return description.has_pipe && finds_vessel_position(description);
}

ModelEquilibrium solve_moored_hull(Model& model) {
  model.mean_pose = model.nominal_pose;
  std::variant<MooredHull, StaticFailure> made = moored_hull(model);
  if (const StaticFailure* failure = std::get_if<StaticFailure>(&made)) {
    return fail(*failure);
  }
  MooredHull& moored = std::get<MooredHull>(made);
  find_initial_equilibrium(model.description, moored);
  if (moored.rest.error) {
    return fail(no_equilibrium(moored));
  }
  const HullPlace place = make_hull_place(moored.hull, moored.rest.offset);
  model.mean_pose = {place.p_W, place.R_WV};
  StaticSolution start;
  start.pose = model.mean_pose;
  return make_equilibrium(model, std::move(start), moored, {});
}

namespace {

/// Solves with the present moment-curvature relation of the steel.
ModelEquilibrium solve_with_present_moments(Model& model, const StaticSolution* start, const LoadHistory& past) {
  model.mean_pose = model.nominal_pose;
  if (!is_moored_lay(model.description)) {
    StaticOutcome pipe = solve_with_stinger(model, start, past);
    if (pipe.solution) measure_stinger(model, *pipe.solution);
    ModelEquilibrium equilibrium;
    equilibrium.solution = std::move(pipe.solution);
    equilibrium.failure = std::move(pipe.failure);
    return equilibrium;
  }
  std::variant<MooredHull, StaticFailure> made = moored_hull(model);
  if (const StaticFailure* failure = std::get_if<StaticFailure>(&made)) {
    return fail(*failure);
  }
  const MooredHull& described = std::get<MooredHull>(made);
  if (start != nullptr) {
    model.mean_pose = start->pose;
  }
  StaticOutcome pipe = solve_with_stinger(model, start, past);
  for (int turn = 0; turn < kMaxIterations; ++turn) {
    if (pipe.failure) {
      return fail(*pipe.failure);
    }
    MooredHull moored = described;
    const Vec6 load = pipe_load(model, *pipe.solution, moored.hull);
    moored.hull.steady += load;
    find_initial_equilibrium(model.description, moored);
    if (moored.rest.error) {
      return fail(no_equilibrium(moored));
    }
    const HullPlace place = make_hull_place(moored.hull, moored.rest.offset);
    const VesselPose pose{place.p_W, place.R_WV};
    if (end_displacement(place, make_hull_place(model.mean_pose), model.description.vessel.length) < kConvergedMove) {
      measure_stinger(model, *pipe.solution);
      const PipeOnHull on_hull = pipe_on_hull(model, *pipe.solution, moored.hull, load);
      return make_equilibrium(model, std::move(*pipe.solution), moored, on_hull);
    }
    model.mean_pose = pose;
    pipe = solve_with_stinger(model, &*pipe.solution, past);
  }
  return fail({"no common equilibrium of pipe and moored hull was found", "the vessel",
               "the pipe load changes more with the vessel's position than the restoring force: increase the tension "
               "of the mooring lines, or the stiffness of dynamic positioning"});
}

}  // namespace

ModelEquilibrium solve_lay(Model& model, const StaticSolution* start, const LoadHistory& past) {
  ModelEquilibrium lay = solve_with_present_moments(model, start, past);
  if (model.description.tensioner.tension) return lay;
  for (int turn = 0; turn < kMaxTensionIterations && lay.solution; ++turn) {
    if (!update_moment_curvature(model, recover_state(model, *lay.solution).top_tension)) break;
    const StaticSolution before = std::move(*lay.solution);
    lay = solve_with_present_moments(model, &before, past);
  }
  return lay;
}

}  // namespace overbend
