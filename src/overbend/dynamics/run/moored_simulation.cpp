#include "dynamics/run/moored_simulation.h"

#include "dynamics/setup/free_start.h"

namespace overbend {

MooredSimulation::MooredSimulation(const Model& model, const StaticSolution& start, const DynamicOptions& options)
    : setup_(make_setup(model, start, 0.0, options)),
      options_(options),
      midship_(model.mean_pose.p_WV),
      ahead_W_(level_ahead(model.drawn_pose)) {
  const LeadEnds lead = [this](const System& system, double time, Surroundings& now) {
    move_vessel(setup_, time, now);
    lead_attachments(system, now);
  };
  setup_.system.surroundings = [this, lead](double time, Surroundings& now) { lead(setup_.system, time, now); };
  SystemState state = state_at_rest(setup_.system, setup_.moorings, make_clock(options, setup_.interval).time());
  failure_ = rest(state);
  if (!failure_) run_.emplace(setup_.system, lead, setup_.sea, std::move(state), options);
}

/// Hull and lines together, or the lines alone on a vessel whose motion is told.
std::optional<StaticFailure> MooredSimulation::rest(SystemState& state) {
  if (setup_.hull) return let_hull_go(setup_.system, setup_.ballast, setup_.hull->hull, options_.release, state);
  Assembly assembly(setup_.system);
  assembly.set_time(state.time, state);
  return rest_mooring_lines(setup_.system, assembly.surroundings().bodies, setup_.mooring_names, state);
}

double MooredSimulation::elevation() const {
  const double time = run_->time();
  const Vec3 at = midship_ + (setup_.move ? setup_.move->at(time).way : 0.0) * ahead_W_;
  return overbend::elevation(setup_.sea, time, half_cosine(time, options_.build_up), at.x(), at.y());
}

}  // namespace overbend
