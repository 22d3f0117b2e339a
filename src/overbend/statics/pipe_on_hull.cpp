#include "statics/pipe_on_hull.h"

#include <utility>

#include "statics/recovery.h"
#include "statics/vessel_load.h"

namespace overbend {
namespace {

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

}  // namespace

Vec6 pipe_load(const Model& model, const StaticSolution& pipe, const HullAtRest& hull) {
  StaticSystem system(model, model.mean_pose, pipe.mesh);
  const Vec6 load = load_on_vessel(system, pipe.state);
  Vec6 drawn;
  drawn << hull.axes_WD.transpose() * load.head<3>(), hull.axes_WD.transpose() * load.tail<3>();
  return drawn;
}

PipeOnHull pipe_on_hull(const Model& model, const StaticSolution& start, const HullAtRest& hull, const Vec6& load) {
  return {load, PipeOnTheWay(model, start, hull)};
}

}  // namespace overbend
