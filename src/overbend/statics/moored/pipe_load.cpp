#include "statics/moored/pipe_load.h"

#include <utility>

#include "model/vessel/stinger_rotation.h"
#include "statics/moored/vessel_load.h"
#include "statics/recovery/recovery.h"
#include "statics/stinger/stinger_forces.h"

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
  pipe.max_reaction = r.max_reaction;
  pipe.max_reaction_support = r.max_reaction_support;
  pipe.lay_back = r.lay_back;
  pipe.stinger_tip_clearance = r.stinger_tip_clearance;
  return pipe;
}

/// Pipe at successive positions of the hull, each solved with a warm start from the last.
class PipeLoadFunction {
 public:
  PipeLoadFunction(const Model& model, StaticSolution start, StaticHull hull)
      : model_(model), last_(std::move(start)), hull_(std::move(hull)) {
    model_.description.checks.codes = CheckCodes::api;  // avoids a second lay without current at each position
  }
  std::variant<PipeAtPosition, StaticFailure> operator()(const HullPlace& place) {
    model_.mean_pose = {place.p_W, place.R_WV};
    StaticOutcome pipe = solve_statics(model_, &last_, last_.past);
    if (pipe.failure) return *pipe.failure;
    last_ = std::move(*pipe.solution);
    return PipeAtPosition{pipe_load(model_, last_, hull_), pipe_at_step(recover_statics(model_, last_))};
  }

 private:
  Model model_;
  StaticSolution last_;
  StaticHull hull_;
};

/// Load of the stinger's weight and buoyancy about midship, W [N, N m].
Vec6 stinger_wrench(const Model& model) {
  Vec6 wrench = Vec6::Zero();
  for (std::size_t i = 0; i < model.supports.sections.size(); ++i) {
    for (const PointForce& force : floating_forces(model, i)) {
      wrench.head<3>() += force.force_W;
      wrench.tail<3>() += (force.at_W - model.mean_pose.p_WV).cross(force.force_W);
    }
  }
  return wrench;
}

/// Difference of that load from the nominal one of hull and stinger.
Vec6 stinger_change(const Model& model) {
  Model drawn;
  drawn.description.supports = model.description.supports;
  drawn.description.vessel = model.description.vessel;
  drawn.water_weight_density = model.water_weight_density;
  drawn.supports.sections = drawn_sections(model.description.supports);
  drawn.mean_pose = model.nominal_pose;
  rotate_stinger(drawn.supports, prescribed_angles(model.description.supports));
  return stinger_wrench(model) - stinger_wrench(drawn);
}

}  // namespace

Vec6 pipe_load(const Model& model, const StaticSolution& pipe, const StaticHull& hull) {
  StaticSystem system = system_with_history(model, pipe.mesh, pipe.past);
  Vec6 load = load_on_vessel(system, pipe.state);
  if (!model.supports.sections.empty()) load += stinger_change(model);
  Vec6 drawn;
  drawn << hull.axes_WD.transpose() * load.head<3>(), hull.axes_WD.transpose() * load.tail<3>();
  return drawn;
}

PipeOnHull pipe_on_hull(const Model& model, const StaticSolution& start, const StaticHull& hull, const Vec6& load) {
  return {load, PipeLoadFunction(model, start, hull)};
}

}  // namespace overbend
