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
  DynamicLine line;
  double interval = 0.5;  ///< Of the clock that steps must meet [s].
};

RunSetup make_setup(const Model& model, const StaticSolution& start, double static_tension,
                    const DynamicOptions& options);

/// Place and direction of the tensioner in the vessel's frame. Behind a guide that lets the pipe turn the machine
/// stands in line with the pipe at rest.
struct TensionerPlace {
  Vec3 place_V, direction_V;
};

TensionerPlace tensioner_place(const Model& model, const StaticSolution& start);

/// The anchor stays where statics put it.
EndMotion anchor_motion(const StaticSolution& start);

}  // namespace overbend
