#include "dynamics/run_setup.h"

#include <cmath>
#include <limits>

#include "dynamics/pull_ahead.h"
#include "dynamics/quasi_static_lines.h"
#include "dynamics/stinger_setup.h"
#include "dynamics/water_field.h"

namespace overbend {

RunSetup make_setup(const Model& model, const StaticSolution& start, double static_tension,
                    const DynamicOptions& options) {
  RunSetup setup;
  const Description& d = model.description;
  setup.sea =
      make_sea(d.environment.waves, d.environment.water_depth, options.build_up + options.duration, options.seed);
  setup.system = pipe_system(model, start, static_tension);
  setup.rollers = setup.system.bodies.front().rollers;
  hang_stinger(model, setup.sea, options.build_up, setup.system);
  const bool quasi_static = d.moorings && d.moorings->model == MooringModel::quasi_static;
  if (start.moorings) {
    setup.mooring_names = mooring_names(*start.moorings);
    if (!quasi_static) {
      setup.moorings = add_mooring_lines(model, *start.moorings, setup.system);
      follow_programs(*start.moorings, winch_programs(start), setup.system);
    }
  }
  if (d.vessel.motion == VesselMotion::coupled) {
    setup.hull = std::make_unique<MadeHull>(make_hull(model, setup.sea, options.build_up));
    setup.hull->hull.mean_drift_from_start = d.statics.mean_drift.value_or(true);
    setup.ballast = d.vessel.coupled->ballast;
    setup.system.bodies.front().free =
        free_hull(setup.hull->hull, setup.system.lines.front().force_scale, d.vessel.length);
    if (start.moorings && quasi_static) {
      setup.system.bodies.front().free->springs = quasi_static_lines(*start.moorings, winch_programs(start));
    }
  } else {
    setup.motion = make_vessel_motion(model, setup.sea);
    if (d.vessel.motion == VesselMotion::raos) setup.wave_numbers_ahead = wave_numbers_ahead(setup.motion, setup.sea);
  }
  if (d.operation.type == OperationType::pull_ahead) {
    setup.move = start.winches ? start.winches->profile : move_profile(d.operation, 0.0);
    const std::optional<JointDescription>& joint = d.pipe.section.joint;
    setup.system.attachments[static_cast<std::size_t>(setup.system.machine)].tensioner.limit =
        std::numeric_limits<double>::infinity();  // a track tensioner feeds without end
    setup.joint = joint ? joint->length : std::abs(d.operation.distance);
  }
  setup.system.build_up = options.build_up;
  setup.interval = water_interval(setup.sea, options.output_step);
  return setup;
}

}  // namespace overbend
