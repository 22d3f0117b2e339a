#include "statics/moored_lay.h"

#include <algorithm>
#include <cmath>

#include "statics/moored_statics.h"
#include "statics/recovery.h"
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

HullPlace place_of(const VesselPose& pose) {
  return {pose.p_WV, pose.R_WV};
}

LayOutcome fail(StaticFailure failure) {
  return {std::nullopt, std::nullopt, std::move(failure)};
}

PipeAtStep pipe_at_step(const StaticResults& r) {
  PipeAtStep pipe;
  pipe.top_tension = r.top_tension;
  pipe.bottom_tension = r.bottom_tension;
  const std::optional<RegionResult>& upper = r.overbend ? r.overbend : r.tower;
  pipe.overbend_bending_stress = upper ? upper->bending_stress.value : 0.0;
  pipe.overbend_strain = upper ? upper->strain.value : 0.0;
  pipe.sagbend_bending_stress = r.sagbend.bending_stress.value;
  pipe.sagbend_strain = r.sagbend.strain.value;
  pipe.largest_reaction = r.largest_reaction;
  pipe.largest_reaction_support = r.largest_reaction_support;
  pipe.lay_back = r.lay_back;
  pipe.stinger_tip_clearance = r.stinger_tip_clearance;
  return pipe;
}

/// The pipe follows the hull from place to place, each solved from the one before.
class PipeOnTheWay {
 public:
  PipeOnTheWay(const Model& model, StaticSolution start, HullAtRest hull)
      : model_(model), last_(std::move(start)), hull_(std::move(hull)) {
    model_.description.checks.codes = CheckCodes::api;  // no second lay without current for each place
  }
  std::variant<PipeThere, StaticFailure> operator()(const HullPlace& place) {
    model_.mean_pose = {place.p_W, place.R_WV};
    StaticOutcome pipe = solve_statics(model_, &last_);
    if (pipe.failure) return *pipe.failure;
    last_ = std::move(*pipe.solution);
    return PipeThere{pipe_load(model_, last_, hull_), pipe_at_step(recover_statics(model_, last_))};
  }

 private:
  Model model_;
  StaticSolution last_;
  HullAtRest hull_;
};

double surge_period(const MooredState& rest) {
  for (const PeriodResult& period : rest.vessel.natural_periods) {
    if (period.mode == "surge") return period.period;
  }
  return 0.0;
}

LayOutcome solved(const Model& model, StaticSolution pipe, const MooredHull& moored, const Vec6& load) {
  std::variant<MooringResults, StaticFailure> outcome =
      moored_results(model, moored, {load, PipeOnTheWay(model, pipe, moored.hull)});
  if (const StaticFailure* failure = std::get_if<StaticFailure>(&outcome)) {
    return fail(*failure);
  }
  MooringResults& results = std::get<MooringResults>(outcome);
  pipe.moorings = moored.spread;
  if (!results.steps.empty()) {
    pipe.winches = winch_plan(model.description.operation, results.steps, surge_period(results.rest));
  }
  return {std::move(pipe), std::move(results), std::nullopt};
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
    const Vec6 load = pipe_load(model, *pipe.solution, moored.hull);
    moored.hull.steady += load;
    find_rest_at_start(model.description, moored);
    if (moored.rest.fault) {
      return fail({"no rest of the moored hull", "static", *moored.rest.fault});
    }
    const HullPlace place = place_of(moored.hull, moored.rest.offset);
    const VesselPose pose{place.p_W, place.R_WV};
    if (way_between(place, place_of(model.mean_pose), model.description.vessel.length) < kStill) {
      return solved(model, std::move(*pipe.solution), moored, load);
    }
    model.mean_pose = pose;
    pipe = solve_statics(model, &*pipe.solution);
  }
  return fail(
      {"pipe and moored hull do not come to rest together", "the vessel",
       "the pipe changes its pull with the vessel's place more than the mooring lines do: give them more tension"});
}

}  // namespace overbend
