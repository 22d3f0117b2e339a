/// Floating hull: its loads and its equations of motion with their tangent.
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "hull/body_kinematics.h"
#include "hull/hull_current.h"
#include "hull/hull_waves.h"
#include "hull/hull_wind.h"
#include "hull/radiation.h"
#include "hull/rigid_body.h"
#include "hull/slow_motion.h"
#include "mechanics/move_profile.h"
#include "mechanics/sea.h"
#include "model/description/hull_description.h"

namespace overbend {

/// A load of the user: constant in W, at a body-fixed point.
struct HullLoad {
  Vec3 arm = Vec3::Zero();                               ///< From the reference point, axes of the body [m].
  Vec3 force_W = Vec3::Zero(), moment_W = Vec3::Zero();  ///< [N], [N m]
};

/// Dynamic positioning to a position and heading, on the low-frequency motion.
struct StationKeeping {
  Vec3 wanted = Vec3::Zero();                         ///< Target x, y, psi, before any move ahead [m, m, rad].
  StationKeepingDescription law;                      ///< Along surge, sway and yaw of the low-frequency heading.
  std::optional<MoveProfile> move = std::nullopt;     ///< Move of the target ahead, if any.
  Eigen::Vector2d ahead_W = Eigen::Vector2d::Zero();  ///< Direction of the move.
};

/// Forward and to port along the low-frequency heading, and bow to port [N, N, N m].
struct StationThrust {
  Vec3 asked = Vec3::Zero();  ///< From spring and damper.
  Vec3 given = Vec3::Zero();  ///< Within the limits.
};

/// Returns the thrust at the low-frequency motion `slow` at `time` [s].
StationThrust station_thrust(const StationKeeping& keeping, const SlowMotion& slow, double time);

/// Damping in addition to radiation, on the rates in H: F = -linear v - quadratic |v| v by component.
struct ViscousDamping {
  Mat6 linear = Mat6::Zero();     ///< [N s/m, N s, N m s]
  Vec6 quadratic = Vec6::Zero();  ///< [N s2/m2], [N m s2]
};

/// Made by make_hull; constant in an analysis.
struct Hull {  // NOLINT(clang-analyzer-optin.performance.Padding): a single instance, in the order of subjects
  Vec3 reference_V = Vec3::Zero();  ///< Reference point in V: the centre of gravity [m].
  Vec6 drawn = Vec6::Zero();        ///< Coordinates of the nominal pose, where buoyancy balances weight.
  /// Coordinates in static equilibrium, which define its heading in waves, current and wind.
  Vec6 lies = Vec6::Zero();
  RigidBody body;
  Mat6 hydrostatics = Mat6::Zero();  ///< On the displacement from `drawn`; heave, roll and pitch only. [N/m, N, N m]
  RadiationModel radiation;
  HullWaves waves;
  HullCurrent current;
  HullWind wind;
  ViscousDamping damping;
  Mat6 drift_damping = Mat6::Zero();  ///< Wave drift damping, in H [N s/m, N s].
  /// A22 - A11 at 0.1 rad/s for the Munk moment of the low-frequency motion through the water; 0 if included in a table
  /// [kg].
  double munk = 0.0;
  Vec6 ballast = Vec6::Zero();  ///< Constant generalised force that trims the hull, from statics [N, N m].
  std::vector<HullLoad> loads;
  std::optional<StationKeeping> station_keeping;
  double low_frequency_period = 40.0;  ///< Corner period of the low-frequency filter [s].
  double build_up = 0.0;               ///< Duration of the ramp of the waves before t = 0 [s]; half a cosine.
  bool mean_drift_from_start = false;  ///< The mean drift acts in full before and during the build-up.

  /// False for a hull with hydrostatics only, for statics: neither waves nor radiation memory.
  bool in_waves() const { return !waves.empty(); }
};

/// Forces of a quasi-static line on its ends, in its vertical plane: initial values of the next solution.
struct LineEndForces {
  double pull = 0.0, sink = 0.0;                  ///< On the hull: towards the anchor, downwards [N].
  double anchor_pull = 0.0, anchor_uplift = 0.0;  ///< On the anchor: towards the hull, upwards [N].
  double length = 0.0, on_bed = 0.0;  ///< Unstressed lengths of the whole line and of the grounded part [m].
  double anchor_rise = 0.0;  ///< Vertical component of the tension at the anchor, also for a line on a slope [N].

  double fairlead_tension() const { return std::hypot(pull, sink); }              ///< [N]
  double anchor_tension() const { return std::hypot(anchor_pull, anchor_rise); }  ///< Along the line [N].
};

/// All memory of the hull. A copy restarts bit for bit.
struct HullState {
  Vec6 h = Vec6::Zero(), v = Vec6::Zero();                           ///< Coordinates and their rates.
  Vec6 acc = Vec6::Zero(), algorithmic_acceleration = Vec6::Zero();  ///< True and algorithmic acceleration.
  RadiationMemory radiation;
  SlowMotion slow;
  std::vector<LineEndForces> lines;  ///< Forces of its quasi-static lines.
  double hinge_slip = 0.0;           ///< Elastic part of the friction of a hinged body [rad].
};

/// Returns the hull at rest at h in water at rest.
HullState make_static_hull(const Hull& hull, const Vec6& h);

/// Weights of the derivatives by h, v and acc in the tangent: changes of v and acc with the unknown.
struct HullWeights {
  double stiffness = 1.0, damping = 0.0, mass = 0.0;
};

/// Environmental loads at the low-frequency position and heading, independent of the wave-frequency motion; in H
/// [N, N m].
struct HullEnvironment {
  double time = 0.0;  ///< [s]
  SlowMotion slow;
  double built_up = 0.0;  ///< Ramp factor of the waves, 0 to 1.
  Vec6 waves = Vec6::Zero(), drift = Vec6::Zero(), wind = Vec6::Zero(), station = Vec6::Zero();
  double munk = 0.0;     ///< Munk moment of the low-frequency motion through the water [N m].
  StripWater water;      ///< Wave velocities at the hull's strips.
  RadiationStep memory;  ///< Memory of the radiated waves.
};

/// Residual and tangent of the hull's equations.
struct HullBalance {
  Vec6 residual = Vec6::Zero();
  Mat6 tangent = Mat6::Zero();
  /// Environment of the present step, found by its first evaluation. To be reset when another step begins.
  std::optional<HullEnvironment> surroundings;
};

/// Time before all waves, which stands for statics.
inline constexpr double kBeforeWaves = -std::numeric_limits<double>::infinity();

/// Computes residual and tangent at `state` (h, v and acc; its memories are not used), which ends a step of length
/// `step` [s] from `before`. Loads at the low-frequency position use the motion extrapolated from the start of the
/// step: they neglect (w_f step)^2 of the displacement by accelerations in a step, and the tangent is exact.
///
/// `step` 0: `state` is at the time of `before`, whose memories are used unchanged. Weights (1, 0, 0) mean statics: the
/// low-frequency motion is then that of h, and its effect is in the tangent; rates should be zero and `time`
/// kBeforeWaves. Does not allocate.
void balance_hull(const Hull& hull, const HullState& state, const HullState& before, double step,
                  const HullWeights& weights, double time, HullBalance& out);

/// Moves the memories of `state` (water, low-frequency motion) from those of `before` to the end of the step. Does not
/// allocate if `state` was once copied from `before`.
void finish_step(const Hull& hull, const HullState& before, double step, HullState& state);

/// Steady loads on the hull at rest in addition to hydrostatics, lines and user loads, about the reference point in H.
/// [N, N m]
struct SteadyForces {
  Vec6 current = Vec6::Zero();  ///< Including the Munk moment.
  Vec6 wind = Vec6::Zero();
  Vec6 drift = Vec6::Zero();  ///< Mean, if `mean_drift_from_start`.

  Vec6 sum() const { return current + wind + drift; }
};

/// Returns the steady part of the loads that balance_hull applies before the waves, with the hull heading psi [rad].
/// Does not allocate.
SteadyForces steady_forces(const Hull& hull, double psi);

/// Returns why the state exceeds the validity of the equations: pitch beyond 60 deg, or not finite; else nullptr.
const char* hull_limit_message(const HullState& state);

/// Powers into the hull's motion by cause [W], and its energies [J].
struct HullEnergy {
  double kinetic = 0.0;      ///< Energy of the rigid body and A_inf.
  double hydrostatic = 0.0;  ///< Energy of `hydrostatics` from the nominal pose.
  double radiation = 0.0, waves = 0.0, drift = 0.0, current = 0.0, wind = 0.0, viscous = 0.0, loads = 0.0,
         ballast = 0.0, station_keeping = 0.0;  ///< Powers into the hull.
  /// Power of the rotation terms of A_inf: the Munk moment, which would return it to yaw, is not among the wave forces.
  double turning = 0.0;
  double power() const {
    return radiation + waves + drift + current + wind + viscous + loads + ballast + station_keeping + turning;
  }
};
/// Returns the energy. `of_step`: environment of the step that ended in `state`, if available.
HullEnergy hull_energy(const Hull& hull, const HullState& state, double time,
                       const std::optional<HullEnvironment>& of_step = std::nullopt);

}  // namespace overbend
