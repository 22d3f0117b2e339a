/// What stands still during a run in time: made once, before the first step.
#pragma once

#include <memory>
#include <optional>

#include "dynamics/integrator/dynamics.h"
#include "dynamics/setup/dynamic_setup.h"
#include "dynamics/setup/end_swing.h"
#include "dynamics/setup/mooring_lines.h"
#include "hull/make_hull.h"
#include "mechanics/moving_vessel.h"
#include "mechanics/sea.h"
#include "mechanics/vessel_motion.h"
#include "system/followed_line.h"

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
  std::vector<FollowedLine> lines;         ///< That stand by themselves, or on the pipe.
  LineShapes moorings;                     ///< First shapes of the mooring lines.
  std::vector<VesselMotionModel> bodies;   ///< Motions of the bodies besides the vessel.
  std::size_t first_body = 0;              ///< Where these begin among the bodies of the system.
  std::vector<EndSwing> swings;            ///< Of ends that move by themselves.
  std::vector<double> wave_numbers_ahead;  ///< Of the terms of `motion`, where the vessel moves ahead.
  std::optional<MoveProfile> move;         ///< Where the vessel is moved ahead.
  double joint = 12.0;                     ///< Length of a pipe joint; of a move where the pipe does not say [m].
  double interval = 0.5;                   ///< Of the clock that steps must meet [s].
  Vec3 water_place = Vec3::Zero();         ///< Where the elevation is told, before any move: stern shoe or midship, W.
};

/// A run before its first step.
struct RunStart {
  RunSetup setup;
  SystemState state;  ///< At the beginning of the build-up; see state_at_start().
};

/// From an equilibrium, its laid pipe carried on behind the static line (laid_tail.h). `top_tension`: of the pipe at
/// its tensioner [N].
RunStart make_run_start(const Model& model, const StaticSolution& start, double top_tension,
                        const DynamicOptions& options);

/// `static_tension`: of the pipe at its tensioner [N]. Lines of the system are the pipe, where there is one, the
/// mooring lines and those that stand by themselves; body 0 is the vessel.
RunSetup make_setup(const Model& model, const StaticSolution& start, double static_tension,
                    const DynamicOptions& options);

/// Moves a vessel whose motion is prescribed, and the ends of lines, to where they are at a time.
void lead_bodies_and_ends(const RunSetup& setup, double time, Surroundings& now);

/// The equilibrium of `start` as a state of the setup's system at `time`, before it is let go: accelerations zero, the
/// bed's friction stretched as statics left it.
SystemState state_at_start(const RunSetup& setup, const StaticSolution& start, double time);

/// Brings that to rest in motion's own equations: a hull that floats free with all lines, the tensioner keeping its
/// tension, and moved by `release` (free_start.h), or mooring lines on a vessel whose motion is prescribed. What the
/// tensioner pays out for that is where it begins. Needs system.surroundings. Says why where there is no rest.
std::optional<StaticFailure> come_to_rest(RunSetup& setup, const Vec6& release, SystemState& state);

}  // namespace overbend
