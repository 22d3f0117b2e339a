/// Initial jump of a prescribed motion from the static position of the vessel.
#pragma once

#include "dynamics/integrator/dynamics.h"
#include "model/model.h"

namespace overbend {

/// Returns the initial displacement of the stern shoe from its static position for a prescribed motion without build-up
/// [m]; 0 with a build-up, and for a hull with computed motion.
double initial_shoe_jump(const Model& model);

/// Returns the initial speed of the stern shoe for a prescribed motion without build-up [m/s]; 0 as above. A motion
/// with zero initial displacement but finite initial velocity, such as a sine, still loads the suspended lines
/// impulsively.
double initial_shoe_speed(const Model& model);

/// Returns the maximum initial displacement of a line end with prescribed motion or on the vessel [m], for lines alone.
double initial_line_end_jump(const Model& model, const DynamicOptions& options);

}  // namespace overbend
