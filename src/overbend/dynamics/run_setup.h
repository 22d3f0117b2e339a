/// What stands still during a run in time: made once, before the first step.
#pragma once

#include "dynamics/dynamic_setup.h"
#include "dynamics/dynamics.h"
#include "mechanics/sea.h"
#include "mechanics/vessel_motion.h"

namespace overbend {

/// Everything that stands still during a run.
struct RunSetup {
  Sea sea;
  VesselMotionModel motion;
  System system;
  double interval = 0.5;  ///< Of the clock that steps must meet [s].
};

RunSetup make_setup(const Model& model, const StaticSolution& start, double static_tension,
                    const DynamicOptions& options);

}  // namespace overbend
