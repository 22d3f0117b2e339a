#include "dynamics/run_setup.h"

#include <cmath>

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
    setup.hull->hull.mean_drift_from_start = d.statics.mean_drift.value_or(true);
    setup.ballast = d.vessel.coupled->ballast;
    setup.system.bodies.front().free =
        free_hull(setup.hull->hull, setup.system.lines.front().force_scale, d.vessel.length);
  } else {
    setup.motion = make_vessel_motion(model, setup.sea);
  }
  setup.system.build_up = options.build_up;
  setup.interval = water_interval(setup.sea, options.output_step);
  return setup;
}

}  // namespace overbend
