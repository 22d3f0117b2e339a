#include "statics/moored_lay.h"

#include <algorithm>
#include <cmath>

#include "statics/moored_statics.h"
#include "statics/vessel_load.h"

namespace overbend {
namespace {

constexpr int kMostTurns = 40;
constexpr double kStill = 1e-7;  ///< Of the ends of the hull, from one turn to the next [m].

/// Load of the pipe on the hull about midship, axes of the hull as drawn.
Vec6 pipe_load(const Model& model, const StaticSolution& pipe, const HullAtRest& hull) {
  StaticSystem system(model, model.mean_pose, pipe.mesh);
  const Vec6 load = load_on_vessel(system, pipe.state);
  Vec6 drawn;
  drawn << hull.axes_WD.transpose() * load.head<3>(), hull.axes_WD.transpose() * load.tail<3>();
  return drawn;
}

/// How far the ends of the hull move from one pose to the other [m].
double way_between(const VesselPose& a, const VesselPose& b, double length) {
  return (a.p_WV - b.p_WV).norm() + 0.5 * length * (a.R_WV - b.R_WV).norm();
}

LayOutcome fail(StaticFailure failure) {
  return {std::nullopt, std::nullopt, std::move(failure)};
}

LayOutcome solved(const Model& model, StaticSolution pipe, const MooredHull& moored) {
  std::variant<MooringResults, StaticFailure> results = moored_results(model, moored);
  if (const StaticFailure* failure = std::get_if<StaticFailure>(&results)) {
    return fail(*failure);
  }
  pipe.moorings = moored.spread;
  return {std::move(pipe), std::get<MooringResults>(std::move(results)), std::nullopt};
}

}  // namespace

bool is_moored_lay(const Description& description) {
  return description.has_pipe && description.moorings && !description.moorings->lines.empty();
}

LayOutcome solve_lay(Model& model, const StaticSolution* start) {
  model.mean_pose = model.drawn_pose;
  if (!is_moored_lay(model.description)) {
    StaticOutcome pipe = solve_statics(model, start);
    return {std::move(pipe.solution), std::nullopt, std::move(pipe.failure)};
  }
  std::variant<MooredHull, StaticFailure> made = moored_hull(model);
  if (const StaticFailure* failure = std::get_if<StaticFailure>(&made)) {
    return fail(*failure);
  }
  const MooredHull& described = std::get<MooredHull>(made);
  if (start != nullptr) {
    model.mean_pose = start->pose;
  }
  StaticOutcome pipe = solve_statics(model, start);
  for (int turn = 0; turn < kMostTurns; ++turn) {
    if (pipe.failure) {
      return fail(*pipe.failure);
    }
    MooredHull moored = described;
    moored.hull.steady += pipe_load(model, *pipe.solution, moored.hull);
    find_rest_at_start(model.description, moored);
    if (moored.rest.fault) {
      return fail({"no rest of the moored hull", "static", *moored.rest.fault});
    }
    const HullPlace place = place_of(moored.hull, moored.rest.offset);
    const VesselPose pose{place.p_W, place.R_WV};
    if (way_between(pose, model.mean_pose, model.description.vessel.length) < kStill) {
      return solved(model, std::move(*pipe.solution), moored);
    }
    model.mean_pose = pose;
    pipe = solve_statics(model, &*pipe.solution);
  }
  return fail(
      {"pipe and moored hull do not come to rest together", "the vessel",
       "the pipe changes its pull with the vessel's place more than the mooring lines do: give them more tension"});
}

}  // namespace overbend
