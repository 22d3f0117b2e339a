#include "dynamics/run_setup.h"

#include <cmath>
#include <limits>

#include "dynamics/water_field.h"

namespace overbend {

RunSetup make_setup(const Model& model, const StaticSolution& start, double static_tension,
                    const DynamicOptions& options) {
  RunSetup setup;
  const Description& d = model.description;
  setup.sea =
      make_sea(d.environment.waves, d.environment.water_depth, options.build_up + options.duration, options.seed);
  setup.system = pipe_system(model, start, static_tension);
  if (start.moorings) {
    setup.mooring_names = mooring_names(*start.moorings);
    setup.moorings = add_mooring_lines(model, *start.moorings, setup.system);
  }
  if (d.vessel.motion == VesselMotion::coupled) {
    setup.hull = std::make_unique<MadeHull>(make_hull(model, setup.sea, options.build_up));
    setup.ballast = d.vessel.coupled->ballast;
    setup.system.bodies.front().free =
        free_hull(setup.hull->hull, setup.system.lines.front().force_scale, d.vessel.length);
  } else {
    setup.motion = make_vessel_motion(model, setup.sea);
    if (d.vessel.motion == VesselMotion::raos) setup.wave_numbers_ahead = wave_numbers_ahead(setup.motion, setup.sea);
  }
  if (d.operation.type == OperationType::pull_ahead) {
    setup.move = move_profile(d.operation, 0.0);
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
