#include "statics/moored/moored_lay.h"

#include <algorithm>
#include <cmath>

#include "model/vessel/station.h"
#include "statics/moored/hull_account.h"
#include "statics/moored/moored_statics.h"
#include "statics/moored/pipe_on_hull.h"
#include "statics/recovery/recovery.h"
#include "statics/stinger/stinger_rest.h"

namespace overbend {
namespace {

constexpr int kMostTurns = 40;
constexpr int kMostTensions = 10;  ///< By which steel that yields is bent in turn, where the tension is a result.
constexpr double kStill = 1e-7;    ///< Of the ends of the hull, from one turn to the next [m].

HullPlace place_of(const VesselPose& pose) {
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

/// `start`: of the pipe, or without one; what the hull's lines do is added.
ModelEquilibrium solved(const Model& model, StaticSolution start, const MooredHull& moored, const PipeOnHull& pipe) {
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

StaticFailure no_rest(const MooredHull& moored) {
  return {"no rest of the moored hull", "static", *moored.rest.fault};
}

}  // namespace

bool is_moored_lay(const Description& description) {
  return description.has_pipe && has_station(description);
}

ModelEquilibrium solve_moored_hull(Model& model) {
  model.mean_pose = model.drawn_pose;
  std::variant<MooredHull, StaticFailure> made = moored_hull(model);
  if (const StaticFailure* failure = std::get_if<StaticFailure>(&made)) {
    return fail(*failure);
  }
  MooredHull& moored = std::get<MooredHull>(made);
  find_rest_at_start(model.description, moored);
  if (moored.rest.fault) {
    return fail(no_rest(moored));
  }
  const HullPlace place = place_of(moored.hull, moored.rest.offset);
  model.mean_pose = {place.p_W, place.R_WV};
  StaticSolution start;
  start.pose = model.mean_pose;
  return solved(model, std::move(start), moored, {});
}

namespace {

/// With the moments of the steel as they are.
ModelEquilibrium solve_bent(Model& model, const StaticSolution* start, const LinePast& past) {
  model.mean_pose = model.drawn_pose;
  if (!is_moored_lay(model.description)) {
    StaticOutcome pipe = rest_with_stinger(model, start, past);
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
  StaticOutcome pipe = rest_with_stinger(model, start, past);
  for (int turn = 0; turn < kMostTurns; ++turn) {
    if (pipe.failure) {
      return fail(*pipe.failure);
    }
    MooredHull moored = described;
    const Vec6 load = pipe_load(model, *pipe.solution, moored.hull);
    moored.hull.steady += load;
    find_rest_at_start(model.description, moored);
    if (moored.rest.fault) {
      return fail(no_rest(moored));
    }
    const HullPlace place = place_of(moored.hull, moored.rest.offset);
    const VesselPose pose{place.p_W, place.R_WV};
    if (way_between(place, place_of(model.mean_pose), model.description.vessel.length) < kStill) {
      measure_stinger(model, *pipe.solution);
      const PipeOnHull on_hull = pipe_on_hull(model, *pipe.solution, moored.hull, load);
      return solved(model, std::move(*pipe.solution), moored, on_hull);
    }
    model.mean_pose = pose;
    pipe = rest_with_stinger(model, &*pipe.solution, past);
  }
  return fail(
      {"pipe and moored hull do not come to rest together", "the vessel",
       "the pipe changes its pull with the vessel's place more than what keeps the vessel there: give mooring lines "
       "more tension, or dynamic positioning more stiffness"});
}

}  // namespace

ModelEquilibrium solve_lay(Model& model, const StaticSolution* start, const LinePast& past) {
  ModelEquilibrium lay = solve_bent(model, start, past);
  if (model.description.tensioner.tension) return lay;
  for (int turn = 0; turn < kMostTensions && lay.solution; ++turn) {
    if (!bend_under(model, recover_state(model, *lay.solution).top_tension)) break;
    const StaticSolution before = std::move(*lay.solution);
    lay = solve_bent(model, &before, past);
  }
  return lay;
}

}  // namespace overbend
