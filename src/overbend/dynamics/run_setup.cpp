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
  setup.motion = make_vessel_motion(model, setup.sea);
  setup.system = pipe_system(model, start, static_tension);
  setup.system.build_up = options.build_up;
  setup.interval = water_interval(setup.sea, options.output_step);
  return setup;
}

}  // namespace overbend
