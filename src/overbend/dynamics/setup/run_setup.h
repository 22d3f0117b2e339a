/// Constant data of a time-domain run: made once, before the first step.
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

/// Constant data of a run.
struct RunSetup {
  Sea sea;
  VesselMotionModel motion;        ///< Prescribed motion; unused if the vessel floats.
  std::unique_ptr<MadeHull> hull;  ///< Hull of a floating vessel; `system` points to it.
  Ballast ballast = Ballast::trim;
  System system;
  /// Rollers of the vessel and of the stinger sections, in the order of the supports.
  std::vector<BodyRoller> rollers;
  std::vector<std::string> mooring_names;
  std::vector<FollowedLine> lines;         ///< Free lines and wires, also those on the pipe.
  LineShapes moorings;                     ///< Initial shapes of the mooring lines.
  std::vector<VesselMotionModel> bodies;   ///< Motions of the bodies other than the vessel.
  std::size_t first_body = 0;              ///< Index of the first of these among the bodies of the system.
  std::vector<EndSwing> swings;            ///< Line ends with harmonic motion.
  std::vector<double> wave_numbers_ahead;  ///< Wave numbers of the terms of `motion`, if the vessel moves ahead.
  std::optional<MoveProfile> move;         ///< Profile of the vessel's move ahead, if any.
  double joint = 12.0;                     ///< Length of a pipe joint, or of a move if the pipe has none [m].
  double interval = 0.5;                   ///< Interval of the clock that steps must meet [s].
  /// Position of the reported elevation, before any move: stern shoe or midship, W.
  Vec3 water_place = Vec3::Zero();
};

/// A run before its first step.
struct RunStart {
  RunSetup setup;
  SystemState state;  ///< State at the beginning of the build-up; see state_at_start().
};

/// Returns the setup and initial state from an equilibrium, with its laid pipe extended behind the static line
/// (laid_tail.h). `top_tension`: of the pipe at its tensioner [N].
RunStart make_run_start(const Model& model, const StaticSolution& start, double top_tension,
                        const DynamicOptions& options);

/// Returns the setup. `static_tension`: of the pipe at its tensioner [N]. Lines of the system are the pipe, if any, the
/// mooring lines and the free lines; body 0 is the vessel.
RunSetup make_setup(const Model& model, const StaticSolution& start, double static_tension,
                    const DynamicOptions& options);

/// Sets the positions of a vessel with prescribed motion and of the line ends at a time.
void set_prescribed_motions(const RunSetup& setup, double time, Surroundings& surroundings);

/// Returns the equilibrium of `start` as a state of the setup's system at `time`, before the hull is released:
/// accelerations zero, stretch of the seabed friction as in statics.
SystemState state_at_start(const RunSetup& setup, const StaticSolution& start, double time);

/// Solves the equilibrium in the equations of motion: of a floating hull with all lines, at constant tensioner tension,
/// then offset by `release` (floating_initial_state.h), or of mooring lines on a vessel with prescribed motion. The
/// resulting tensioner payout is its initial value. Needs system.surroundings. Returns a failure if there is no
/// equilibrium.
std::optional<StaticFailure> solve_initial_equilibrium(RunSetup& setup, const Vec6& release, SystemState& state);

}  // namespace overbend
