/// What stands still during a run in time: made once, before the first step.
#pragma once

#include <memory>
#include <optional>

#include "dynamics/integrator/dynamics.h"
#include "dynamics/setup/dynamic_setup.h"
#include "dynamics/setup/mooring_lines.h"
#include "hull/make_hull.h"
#include "mechanics/moving_vessel.h"
#include "mechanics/sea.h"
#include "mechanics/vessel_motion.h"

namespace overbend {

/// Everything that stands still during a run.
struct RunSetup {
  Sea sea;
  VesselMotionModel motion;        ///< Told; not where the vessel floats free.
  std::unique_ptr<MadeHull> hull;  ///< Where it does; `system` points to it.
  Ballast ballast = Ballast::trim;
  System system;
  std::vector<BodyRoller> rollers;  ///< Of the vessel and of the stinger's sections, in the order of the supports.
  std::vector<std::string> mooring_names;
  LineShapes moorings;  ///< First shapes of the mooring lines, which stand among the lines from first_mooring() on.
  std::vector<double> wave_numbers_ahead;  ///< Of the terms of `motion`, where the vessel moves ahead.
  std::optional<MoveProfile> move;         ///< Where the vessel is moved ahead.
  double joint = 12.0;                     ///< Length of a pipe joint; of a move where the pipe does not say [m].
  double interval = 0.5;                   ///< Of the clock that steps must meet [s].
};

/// `static_tension`: of the pipe at its tensioner [N]. Without a pipe the system is the vessel with its mooring lines.
RunSetup make_setup(const Model& model, const StaticSolution& start, double static_tension,
                    const DynamicOptions& options);

/// Moves a vessel whose motion is told to where it is at a time.
void move_vessel(const RunSetup& setup, double time, Surroundings& now);

}  // namespace overbend
