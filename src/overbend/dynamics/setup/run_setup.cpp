#include "dynamics/setup/run_setup.h"

#include <cmath>
#include <limits>

#include "dynamics/integrator/water_field.h"
#include "dynamics/setup/pull_ahead.h"
#include "dynamics/setup/quasi_static_lines.h"
#include "dynamics/setup/stinger_setup.h"
#include "moorings/equilibrium.h"

namespace overbend {
namespace {

bool is_quasi_static(const Description& d) {
  return d.moorings && d.moorings->model == MooringModel::quasi_static;
}

void add_moorings(const Model& model, const StaticSolution& start, RunSetup& setup) {
  if (!start.moorings) return;
  setup.mooring_names = mooring_names(*start.moorings);
  if (is_quasi_static(model.description)) return;
  setup.moorings = add_mooring_lines(model, *start.moorings, setup.system);
  follow_programs(*start.moorings, winch_programs(start), setup.system);
}

/// Of the balance of a hull: of its pipe, else of what keeps it in its place.
double scale_of(const Description& d, const StaticSolution& start, const RunSetup& setup) {
  if (setup.system.machine >= 0) return setup.system.lines.front().force_scale;
  return force_scale(*start.moorings, d.station_keeping);
}

/// The vessel's motion: told, or that of a hull that floats free.
void add_motion(const Model& model, const StaticSolution& start, const DynamicOptions& options, RunSetup& setup) {
  const Description& d = model.description;
  if (d.vessel.motion != VesselMotion::coupled) {
    setup.motion = make_vessel_motion(model, setup.sea);
    if (d.vessel.motion == VesselMotion::raos) setup.wave_numbers_ahead = wave_numbers_ahead(setup.motion, setup.sea);
    return;
  }
  setup.hull = std::make_unique<MadeHull>(make_hull(model, setup.sea, options.build_up, start.station_stiffness));
  setup.hull->hull.mean_drift_from_start = d.statics.mean_drift.value_or(true);
  setup.ballast = d.vessel.coupled->ballast;
  FreeBody& body =
      setup.system.bodies.front().free.emplace(free_hull(setup.hull->hull, scale_of(d, start, setup), d.vessel.length));
  if (start.moorings && is_quasi_static(d)) {
    body.springs = quasi_static_lines(*start.moorings, winch_programs(start));
  }
}

void add_move(const Model& model, const StaticSolution& start, RunSetup& setup) {
  const Description& d = model.description;
  if (d.operation.type != OperationType::pull_ahead) return;
  setup.move = start.winches ? start.winches->profile : move_profile(d.operation, 0.0);
  const std::optional<JointDescription>& joint = d.pipe.section.joint;
  setup.joint = joint ? joint->length : std::abs(d.operation.distance);
  if (setup.hull && setup.hull->hull.station_keeping) {
    StationKeeping& keeping = *setup.hull->hull.station_keeping;
    keeping.move = setup.move;
    keeping.ahead_W = level_ahead(model.drawn_pose).head<2>();
  }
  if (setup.system.machine < 0) return;
  setup.system.attachments[static_cast<std::size_t>(setup.system.machine)].tensioner.limit =
      std::numeric_limits<double>::infinity();  // a track tensioner feeds without end
}

}  // namespace

RunSetup make_setup(const Model& model, const StaticSolution& start, double static_tension,
                    const DynamicOptions& options) {
  RunSetup setup;
  const Description& d = model.description;
  setup.sea = make_sea(d.environment.waves, d.environment.water_depth, options.seed);
  if (d.has_pipe) {
    setup.system = pipe_system(model, start, static_tension);
    setup.rollers = setup.system.bodies.front().rollers;
    hang_stinger(model, setup.sea, options.build_up, setup.system);
  } else {
    setup.system.bodies.emplace_back();  // the vessel
  }
  add_moorings(model, start, setup);
  add_motion(model, start, options, setup);
  add_move(model, start, setup);
  setup.system.build_up = options.build_up;
  setup.interval = water_interval(setup.sea, options.output_step);
  return setup;
}

void move_vessel(const RunSetup& setup, double time, Surroundings& now) {
  if (setup.hull) return;
  const MoveAhead ahead{setup.move ? setup.move->at(time) : WayPoint{}, setup.wave_numbers_ahead};
  now.bodies.front() = vessel_motion(setup.motion, ahead, time, half_cosine(time, setup.system.build_up));
}

}  // namespace overbend
